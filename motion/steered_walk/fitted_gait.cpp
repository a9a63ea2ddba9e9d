#include "motion/steered_walk/fitted_gait.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "motion/procedural/stance_fit.h"
#include "motion/procedural/walker_legs.h"
#include "motion/steered_walk/paced_style.h"

namespace mien::motion {

namespace {

constexpr std::size_t gait_numbers = sizeof(FittedGait) / sizeof(double);
using GaitNumbers = std::array<double, gait_numbers>;
static_assert(std::is_trivially_copyable_v<FittedGait> &&
              sizeof(GaitNumbers) == sizeof(FittedGait));

GaitNumbers numbers_of_gait(const FittedGait& gait) {
  GaitNumbers numbers;
  std::memcpy(&numbers, &gait, sizeof numbers);
  return numbers;
}

FittedGait gait_of(const GaitNumbers& numbers) {
  FittedGait gait;
  std::memcpy(static_cast<void*>(&gait), &numbers, sizeof numbers);
  return gait;
}

/// Whether one leg is the other in the mirror.
bool are_alike(const LegCycle& a, const LegCycle& b) {
  const Vec3 other(-b.hip_offset.x(), b.hip_offset.y(), b.hip_offset.z());
  return (a.hip_offset - other).norm() < 1e-9 && std::abs(a.thigh_m - b.thigh_m) < 1e-9 &&
         std::abs(a.shank_m - b.shank_m) < 1e-9;
}

constexpr double most_landing = 0.1;        // radians
constexpr double weight_over_feet = 0.035;  // of the pelvis before the ankles, of 1.75 m, standing

std::array<LegCycle, 2> unfitted_legs(const WalkStyle& style, const Skeleton& body,
                                      double speed_m_s) {
  PelvisPath pelvis;
  pelvis.style = style;
  pelvis.stride_m = speed_m_s * 120.0 / style.cadence_steps_min;
  return {make_leg(body, pelvis, true), make_leg(body, pelvis, false)};
}

}  // namespace

FittedGait fit_gait(const WalkStyle& style, const Skeleton& body) {
  FittedGait gait;
  gait.style = scaled_to(body, style);
  std::array<LegCycle, 2> legs = unfitted_legs(gait.style, body, gait.style.speed_m_s);
  fit_stance(legs);
  gait.mean_height_m = legs[0].pelvis.mean_height_m;
  gait.passing_phase = legs[0].ahead_m / legs[0].pelvis.stride_m;
  for (std::size_t side = 0; side < 2; ++side) {
    if (side == 1 && are_alike(legs[0], legs[1])) {
      gait.swings[1] = gait.swings[0];
      continue;
    }
    const LegCycle leg = fit_swing(legs[side]);
    // Steps that are short come down flat, which the search for a landing from above overdoes.
    gait.swings[side] = {leg.knee_peak, leg.lift, std::min(leg.landing, most_landing)};
  }
  return gait;
}

FittedGait fit_standing(const WalkStyle& style, const Skeleton& body) {
  FittedGait gait = fit_gait(standing_style(style), body);
  gait.passing_phase = 0.25;
  gait.ahead_m = -weight_over_feet * relative_stature(body);
  return gait;
}

FittedGait blended(std::span<const FittedGait> gaits, std::span<const double> weights) {
  assert(gaits.size() == weights.size());
  GaitNumbers sum{};
  for (std::size_t g = 0; g < gaits.size(); ++g) {
    if (weights[g] == 0.0) continue;
    const GaitNumbers numbers = numbers_of_gait(gaits[g]);
    for (std::size_t i = 0; i < gait_numbers; ++i) sum[i] += weights[g] * numbers[i];
  }
  return gait_of(sum);
}

std::array<LegCycle, 2> legs_of(const FittedGait& gait, const Skeleton& body, double speed_m_s) {
  std::array<LegCycle, 2> legs = unfitted_legs(gait.style, body, speed_m_s);
  for (std::size_t side = 0; side < 2; ++side) {
    LegCycle& leg = legs[side];
    leg.pelvis.mean_height_m = gait.mean_height_m;
    leg.ahead_m = gait.passing_phase * leg.pelvis.stride_m + gait.ahead_m;
    leg.knee_peak = gait.swings[side].knee_peak;
    leg.lift = gait.swings[side].lift;
    leg.landing = gait.swings[side].landing;
    leg = with_swing_curves(leg);
  }
  return legs;
}

}  // namespace mien::motion
