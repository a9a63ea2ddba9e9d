#include "motion/procedural/walker_legs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "motion/error.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/two_bone_ik.h"

namespace mien::motion {

namespace {

constexpr double reference_leg_length = 0.85;  // of standard_body(1.75)

/// World rotation of the thigh that points a slightly bent leg at the ankle, knee towards `pole`.
Quat aimed_thigh(const Vec3& line, const Vec3& pole) {
  return frame_from(line, pole) * frame_from(-Vec3::UnitY(), Vec3::UnitZ()).conjugate();
}

/// An angle by which a knee points outward, radians, that knees of legs that turn do not point in
/// front of each other: what is inward by more than in straight walks is taken back.
double kept_outward(double angle) {
  constexpr double free = 0.12;
  constexpr double most = 0.2;
  const double more = -angle - free;
  if (more <= 0.0) return angle;
  return -free - (most - free) * std::tanh(more / (most - free));
}

Vec3 knee_direction(const LegCycle& leg, const Quat& pelvis_rotation, const FootPose& foot) {
  const double splay = leg.side * radians_per_degree * leg.pelvis.style.knee_splay_deg;
  const Vec3 forward = pelvis_rotation * Vec3::UnitZ();
  const double facing = std::atan2(forward.x(), forward.z());
  const double between = 0.6 * std::remainder(foot.yaw - facing, 2.0 * pi);
  const double yaw = facing + leg.side * kept_outward(leg.side * between) + splay;
  return {std::sin(yaw), 0.0, std::cos(yaw)};
}

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

WalkStyle scaled_to(const Skeleton& body, WalkStyle style) {
  const double scale = leg_length(body) / reference_leg_length;
  for (double* metres : {&style.speed_m_s, &style.step_width_m, &style.foot_clearance_m,
                         &style.bounce_m, &style.sway_m, &style.impact_m}) {
    *metres *= scale;
  }
  return style;
}

LegCycle make_leg(const Skeleton& body, const PelvisPath& pelvis, bool left) {
  const BodyJoint hip = left ? LeftHip : RightHip;
  const auto offset = [&](int below) {
    return body.joints[static_cast<size_t>(hip + below)].offset;
  };
  LegCycle leg;
  leg.pelvis = pelvis;
  leg.side = left ? 1.0 : -1.0;
  leg.phase_offset = left ? 0.0 : 0.5;
  leg.hip_offset = offset(0);
  leg.thigh_m = offset(1).norm();
  leg.shank_m = offset(2).norm();
  leg.foot = foot_shape(body, BodyJoint(hip + 2));
  return leg;
}

void set_leg(const LegCycle& leg, const FootPose& foot, const Skeleton& body, Pose& pose) {
  const BodyJoint hip = leg.side > 0 ? LeftHip : RightHip;
  const auto offset = [&](int below) {
    return body.joints[static_cast<size_t>(hip + below)].offset;
  };
  const auto local = [&](int below) -> Quat& {
    return pose.rotations[static_cast<size_t>(hip + below)];
  };
  const Quat& pelvis = pose.rotations[Pelvis];
  const Vec3 root = pose.root_position + pelvis * offset(0);
  const Vec3 pole = knee_direction(leg, pelvis, foot);

  const Quat bend(Eigen::AngleAxisd(0.5, Vec3::UnitX()));
  const Quat thigh_guess = aimed_thigh(foot.ankle - root, pole);
  const Quat shank_guess = thigh_guess * bend;
  const Vec3 knee = root + thigh_guess * offset(1);
  const TwoBoneLimb guess{root, knee, knee + shank_guess * offset(2)};
  const TwoBoneSolution solution = solve_two_bone(guess, foot.ankle, pole);

  const Quat thigh = solution.upper_turn * thigh_guess;
  const Quat shank = solution.lower_turn * shank_guess;
  const Quat sole = foot_rotation(foot);
  local(0) = pelvis.conjugate() * thigh;
  local(1) = thigh.conjugate() * shank;
  local(2) = shank.conjugate() * sole;
  local(3) = Quat(Eigen::AngleAxisd(-foot.toe_extension, Vec3::UnitX()));
}

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
