#include "motion/procedural/stance_fit.h"

#include <algorithm>
#include <array>
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

/// Highest mean height of the pelvis at which this leg keeps the style's knee flexion all through
/// its stance. A leg whose pelvis is still at mean height 0 is expected.
double highest_pelvis(const LegCycle& leg) {
  constexpr int samples = 128;
  double highest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= samples; ++i) {
    const double phase = leg.pelvis.style.stance_share * i / samples;
    const Vec3 line = hip_position(leg, phase + leg.phase_offset) - planted_foot(leg, phase).ankle;
    const double longest = longest_leg(leg, phase);
    const double across = std::hypot(line.x(), line.z());
    if (across >= longest) return unreachable;
    highest = std::min(highest, std::sqrt(longest * longest - across * across) - line.y());
  }
  return highest;
}

/// Height when the pelvis passes over the ankle at this phase of the stance.
double height_passing_at(std::array<LegCycle, 2>& legs, double phase) {
  double height = std::numeric_limits<double>::infinity();
  for (LegCycle& leg : legs) {
    leg.ahead_m = phase * leg.pelvis.stride_m;
    height = std::min(height, highest_pelvis(leg));
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
  double best_phase = earliest;
  double height = unreachable;
  for (int i = 0; i <= steps; ++i) {
    const double phase = earliest + (latest - earliest) * i / steps;
    const double reached = height_passing_at(legs, phase);
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
