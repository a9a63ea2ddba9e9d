#include "motion/steered_walk/walker_gaits.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "motion/error.h"
#include "motion/procedural/walk_style.h"
#include "motion/procedural/walker_legs.h"

namespace mien::motion {

namespace {

constexpr double standing_knee_deg = 4.0;  // least, of people who stand

double mixed(double at_zero, double at_one, double share) {
  return at_zero + (at_one - at_zero) * share;
}

/// The style at a share of its own speed, from 0 (stepping on the spot) to 1.3: cadence falls to
/// 0.72 of its own at 0, the rest is step length. With shorter steps the feet strike, leave the
/// floor and swing less, the body bounces and turns less, arms hang; postures stay. Feet are set
/// wider apart and stand for longer (after Murray et al. 1984; Winter 1991). 1 is the style itself.
///
/// `at_pace` (affective_walk.h) changes step and cadence equally, as people do who walk slowly for
/// long; this is how they walk for a step or two, before they stop or when they have just started.
WalkStyle paced_style(const WalkStyle& style, double pace) {
  WalkStyle s = style;
  const double slower = std::max(0.0, 1.0 - pace);
  const double cadence = pace < 1.0 ? mixed(0.72, 1.0, pace) : std::pow(pace, 0.7);
  const double step = pace / cadence;
  s.cadence_steps_min *= cadence;
  s.speed_m_s = std::max(1e-3, style.speed_m_s * pace);
  s.stance_share = std::clamp(style.stance_share + 0.05 * (1.0 - pace), 0.56, 0.74);
  s.heel_rise_share =
      s.stance_share * mixed(0.74, style.heel_rise_share / style.stance_share, std::min(step, 1.0));
  s.step_width_m += (0.06 + 0.4 * std::max(0.0, 0.09 - style.step_width_m)) * slower * slower;
  s.foot_clearance_m += 0.015 * slower * slower;
  s.heel_strike_deg *= mixed(0.1, 1.0, step);
  s.toe_off_deg *= mixed(0.12, 1.0, step);
  s.swing_knee_deg *= mixed(0.7, 1.0, std::min(step, 1.0));
  s.bounce_m *= mixed(0.12, 1.0, step * step);
  s.impact_m *= mixed(0.2, 1.0, step);
  s.sway_m *= mixed(1.9, 1.0, pace);
  s.pelvis_rotation_deg *= mixed(0.1, 1.0, step);
  s.pelvis_obliquity_deg *= mixed(0.45, 1.0, step);
  s.trunk_rotation_deg *= mixed(0.15, 1.0, step);
  s.head_sway_deg *= mixed(0.3, 1.0, step);
  s.arm_swing_deg *= mixed(0.1, 1.0, pace);
  s.elbow_swing_deg *= mixed(0.1, 1.0, pace);
  s.wrist_swing_deg *= mixed(0.2, 1.0, pace);
  return s;
}

/// The posture of the style without its movements: for standing. The feet are as wide apart as at
/// pace 0.
WalkStyle standing_style(const WalkStyle& style) {
  WalkStyle s = paced_style(style, 0.0);
  s.heel_strike_deg = 0.0;
  s.toe_off_deg = 0.0;
  s.stance_knee_deg = std::max(s.stance_knee_deg, standing_knee_deg);
  for (double WalkStyle::*movement :
       {&WalkStyle::bounce_m, &WalkStyle::impact_m, &WalkStyle::sway_m,
        &WalkStyle::pelvis_rotation_deg, &WalkStyle::pelvis_obliquity_deg,
        &WalkStyle::trunk_rotation_deg, &WalkStyle::trunk_sway_deg, &WalkStyle::head_sway_deg,
        &WalkStyle::arm_swing_deg, &WalkStyle::elbow_swing_deg, &WalkStyle::wrist_swing_deg}) {
    s.*movement = 0.0;
  }
  return s;
}

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

MoodGaits fit_mood(const WalkStyle& style, const Skeleton& body) {
  MoodGaits mood;
  for (const double pace : gait_paces) {
    mood.paced.push_back(fit_gait(paced_style(style, pace), body));
    if (pace == 1.0) mood.speed_m_s = mood.paced.back().style.speed_m_s;
  }
  mood.standing = fit_standing(style, body);
  // Who steps on the spot stands over their feet as in standing.
  mood.paced.front().ahead_m = mood.standing.ahead_m;
  mood.paced.front().passing_phase = mood.standing.passing_phase;
  return mood;
}

/// Weights of the paces: linear between neighbours.
std::array<double, gait_paces.size()> pace_weights(double pace) {
  std::array<double, gait_paces.size()> weights{};
  const double within = std::clamp(pace, gait_paces.front(), gait_paces.back());
  const auto above = std::upper_bound(gait_paces.begin() + 1, gait_paces.end() - 1, within);
  const auto i = static_cast<std::size_t>(above - gait_paces.begin());
  const double share = (within - gait_paces[i - 1]) / (gait_paces[i] - gait_paces[i - 1]);
  weights[i - 1] = 1.0 - share;
  weights[i] = share;
  return weights;
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

WalkerGaits fit_walker(std::span<const WalkStyle> moods, const Skeleton& body) {
  if (moods.empty()) throw Error("a walker needs a style", "give at least one style");
  WalkerGaits gaits;
  gaits.body = body;
  for (const WalkStyle& style : moods) gaits.moods.push_back(fit_mood(style, body));
  return gaits;
}

double own_speed(const WalkerGaits& gaits, std::span<const double> moods) {
  double speed = 0.0;
  for (std::size_t m = 0; m < moods.size(); ++m) speed += moods[m] * gaits.moods[m].speed_m_s;
  return speed;
}

FittedGait gait_at(const WalkerGaits& gaits, std::span<const double> moods, double speed_m_s,
                   double activity) {
  const auto paces = pace_weights(speed_m_s / own_speed(gaits, moods));
  std::vector<FittedGait> nodes;
  std::vector<double> weights;
  const auto add = [&](const FittedGait& gait, double weight) {
    if (weight == 0.0) return;
    nodes.push_back(gait);
    weights.push_back(weight);
  };
  for (std::size_t m = 0; m < moods.size(); ++m) {
    add(gaits.moods[m].standing, moods[m] * (1.0 - activity));
    for (std::size_t p = 0; p < paces.size(); ++p) {
      add(gaits.moods[m].paced[p], moods[m] * activity * paces[p]);
    }
  }
  return blended(nodes, weights);
}

}  // namespace mien::motion
