#include "motion/procedural/stance_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "motion/error.h"

namespace mien::motion {

namespace {

constexpr double unreachable = -std::numeric_limits<double>::infinity();

/// Hip to ankle when the knee is as straight as it may be. A knee that is all but straight at heel
/// strike would have to give way with a jerk when the weight comes onto it.
double longest_leg(const LegCycle& leg, double phase) {
  constexpr double loading = 0.06;
  const double more = phase < loading ? 2.0 : 0.0;
  return leg_length_at(leg, radians_per_degree * (leg.pelvis.style.stance_knee_deg + more));
}

constexpr int stance_samples = 128;

/// What a leg's stance has at a moment wherever its print lies. The pelvis is at mean height 0.
struct StanceMoment {
  Vec3 hip;
  FootRoll roll;
  double longest_m = 0.0;  ///< from hip to ankle
};
using StanceMoments = std::array<StanceMoment, stance_samples + 1>;

StanceMoments stance_moments(const LegCycle& leg) {
  StanceMoments moments;
  const WalkStyle& style = leg.pelvis.style;
  for (int i = 0; i <= stance_samples; ++i) {
    const double phase = style.stance_share * i / stance_samples;
    moments[static_cast<std::size_t>(i)] = {
        hip_position(leg, phase + leg.phase_offset),
        foot_roll(leg.foot, yaw_of(leg), stance_pitch(style, phase)), longest_leg(leg, phase)};
  }
  return moments;
}

/// Highest mean height of the pelvis at which this leg keeps the style's knee flexion all through
/// its stance.
double highest_pelvis(const LegCycle& leg, const StanceMoments& moments) {
  const Vec3 print = print_of(leg);
  double highest = std::numeric_limits<double>::infinity();
  for (const StanceMoment& moment : moments) {
    const Vec3 line = moment.hip - rolled_ankle(leg.foot, print, moment.roll);
    const double longest = moment.longest_m;
    const double across = std::hypot(line.x(), line.z());
    if (across >= longest) return unreachable;
    highest = std::min(highest, std::sqrt(longest * longest - across * across) - line.y());
  }
  return highest;
}

/// Height when the pelvis passes over the ankle at this phase of the stance.
double height_passing_at(std::array<LegCycle, 2>& legs, const std::array<StanceMoments, 2>& moments,
                         double phase) {
  double height = std::numeric_limits<double>::infinity();
  for (std::size_t side = 0; side < 2; ++side) {
    legs[side].ahead_m = phase * legs[side].pelvis.stride_m;
    height = std::min(height, highest_pelvis(legs[side], moments[side]));
  }
  return height;
}

[[noreturn]] void refuse(const LegCycle& leg) {
  // No streams: with them the module for browsers would bring a locale.
  std::array<char, 80> wrong{};
  std::snprintf(wrong.data(), wrong.size(), "steps of %.3g m are too long for legs of %.3g m",
                0.5 * leg.pelvis.stride_m, leg.thigh_m + leg.shank_m);
  throw Error(wrong.data(), "lower the walk's speed or raise its cadence");
}

}  // namespace

void fit_stance(std::array<LegCycle, 2>& legs) {
  // Earlier passing stretches the trailing leg, later passing the leading one: the height over the
  // phase has one peak.
  constexpr double earliest = 0.18;
  constexpr double latest = 0.32;
  constexpr int steps = 56;
  const std::array<StanceMoments, 2> moments = {stance_moments(legs[0]), stance_moments(legs[1])};
  double best_phase = earliest;
  double height = unreachable;
  for (int i = 0; i <= steps; ++i) {
    const double phase = earliest + (latest - earliest) * i / steps;
    const double reached = height_passing_at(legs, moments, phase);
    if (reached > height) {
      height = reached;
      best_phase = phase;
    }
  }
  if (height == unreachable) refuse(legs[0]);
  for (LegCycle& leg : legs) {
    leg.ahead_m = best_phase * leg.pelvis.stride_m;
    leg.pelvis.mean_height_m = height;
  }
}

}  // namespace mien::motion
