#include "motion/procedural/walker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

#include "motion/error.h"
#include "motion/math/rotation.h"
#include "motion/procedural/leg_cycle.h"
#include "motion/procedural/stance_fit.h"
#include "motion/procedural/upper_body.h"
#include "motion/skeleton/two_bone_ik.h"

namespace mien::motion {

namespace {

constexpr double reference_leg_length = 0.85;  // of standard_body(1.75)

struct Walker {
  PelvisPath pelvis;
  std::array<LegCycle, 2> legs;  ///< left, right
};

std::string rounded(double value) {
  std::ostringstream text;
  text << std::setprecision(3) << value;
  return text.str();
}

void require(bool holds, std::string_view wrong, std::string_view remedy) {
  if (!holds) throw Error(wrong, remedy);
}

void check(const WalkStyle& style, double frames_per_second) {
  require(frames_per_second > 0.0, "the frame rate of a walk is not positive", "give it in 1/s");
  require(style.speed_m_s > 0.0 && style.cadence_steps_min > 0.0,
          "speed or cadence of a walk is not positive", "give them in m/s and steps/min");
  require(style.stance_share > 0.5 && style.stance_share < 0.85,
          "stance_share " + rounded(style.stance_share) + " leaves no walk",
          "choose it above 0.5 and below 0.85");
  require(style.heel_strike_deg >= 0.0 && style.toe_off_deg >= 0.0,
          "a walk's heel_strike_deg or toe_off_deg is negative", "use 0 for a flat foot");
}

/// The style with its lengths, and with them its speed, in proportion to the legs.
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

Walker make_walker(const WalkStyle& style, double cycle_seconds, const Skeleton& body) {
  PelvisPath pelvis;
  pelvis.style = style;
  pelvis.stride_m = style.speed_m_s * cycle_seconds;
  Walker walker;
  walker.legs = {make_leg(body, pelvis, true), make_leg(body, pelvis, false)};
  fit_stance(walker.legs);
  for (LegCycle& leg : walker.legs) leg = fit_swing(leg);
  walker.pelvis = walker.legs[0].pelvis;
  return walker;
}

/// World rotation of the thigh that points a slightly bent leg at the ankle, knee towards `pole`.
Quat aimed_thigh(const Vec3& line, const Vec3& pole) {
  return frame_from(line, pole) * frame_from(-Vec3::UnitY(), Vec3::UnitZ()).conjugate();
}

Vec3 knee_direction(const LegCycle& leg, const Quat& pelvis_rotation, const FootPose& foot) {
  const double splay = leg.side * radians_per_degree * leg.pelvis.style.knee_splay_deg;
  const Vec3 forward = pelvis_rotation * Vec3::UnitZ();
  const double facing = std::atan2(forward.x(), forward.z());
  const double yaw = 0.4 * facing + 0.6 * foot.yaw + splay;
  return {std::sin(yaw), 0.0, std::cos(yaw)};
}

void set_leg(const LegCycle& leg, double phase, const Skeleton& body, Pose& pose) {
  const BodyJoint hip = leg.side > 0 ? LeftHip : RightHip;
  const auto offset = [&](int below) {
    return body.joints[static_cast<size_t>(hip + below)].offset;
  };
  const auto local = [&](int below) -> Quat& {
    return pose.rotations[static_cast<size_t>(hip + below)];
  };
  const Quat& pelvis = pose.rotations[Pelvis];
  const FootPose foot = foot_at(leg, phase);
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

Pose pose_of(const Walker& walker, double phase, const Skeleton& body) {
  Pose pose;
  pose.rotations.assign(body_joint_count, Quat::Identity());
  pose.root_position = pelvis_position(walker.pelvis, phase);
  pose.rotations[Pelvis] = pelvis_rotation(walker.pelvis, phase);
  set_upper_body(walker.pelvis.style, phase, pose.rotations[Pelvis], pose);
  for (const LegCycle& leg : walker.legs) set_leg(leg, phase, body, pose);
  for (Quat& rotation : pose.rotations) {
    rotation = in_hemisphere_of(Quat::Identity(), rotation.normalized());
  }
  return pose;
}

/// Phase between `from` and `to` at which the swinging ankle overtakes the standing one.
double passing_phase(const LegCycle& standing, const LegCycle& swinging, double from, double to) {
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (from + to);
    const bool behind = foot_at(swinging, middle).ankle.z() < foot_at(standing, middle).ankle.z();
    (behind ? from : to) = middle;
  }
  return 0.5 * (from + to);
}

std::vector<double> keytimes(const Walker& walker, double cycle_seconds) {
  const double stance = walker.pelvis.style.stance_share;
  const auto& [left, right] = walker.legs;
  const std::array<double, 7> phases = {
      0.0, stance - 0.5, passing_phase(left, right, stance - 0.5, 0.5),
      0.5, stance,       passing_phase(right, left, stance, 1.0),
      1.0};
  std::vector<double> seconds;
  for (const double phase : phases) seconds.push_back(phase * cycle_seconds);
  return seconds;
}

}  // namespace

Example walk(const WalkStyle& style, double frames_per_second, const Skeleton& body) {
  check(style, frames_per_second);
  const double cycle_wanted = 120.0 / style.cadence_steps_min;
  const int frames = std::max(8, static_cast<int>(std::lround(cycle_wanted * frames_per_second)));
  const double cycle_seconds = frames / frames_per_second;
  WalkStyle own = scaled_to(body, style);
  own.speed_m_s *= cycle_wanted / cycle_seconds;
  const Walker walker = make_walker(own, cycle_seconds, body);

  Example example;
  example.clip.body = body;
  example.clip.frames_per_second = frames_per_second;
  example.clip.loops = true;
  example.clip.cycle_displacement = Vec3(0, 0, walker.pelvis.stride_m);
  const double start = pelvis_position(walker.pelvis, 0.0).z();
  for (int i = 0; i < frames; ++i) {
    Pose pose = pose_of(walker, static_cast<double>(i) / frames, body);
    pose.root_position.z() -= start;
    example.clip.poses.push_back(std::move(pose));
  }
  example.keytimes = keytimes(walker, cycle_seconds);
  return example;
}

}  // namespace mien::motion
