#include "motion/procedural/walker_legs.h"

#include <cmath>

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

}  // namespace mien::motion
