#include <algorithm>
#include <cmath>

#include "motion/math/rotation.h"
#include "motion/procedural/walker.h"
#include "motion/procedural/walker_legs.h"
#include "motion/skeleton/pose.h"
#include "motion/steered_walk/steered_moment.h"

namespace mien::motion {

namespace {

constexpr double least_knee_deg = 2.5;          // of a leg that reaches as far as it may
constexpr double most_dorsiflexion_deg = 17.0;  // before the heel rises
constexpr double soft_reach_m = 0.0015;         // within which the pelvis gives way

Quat about_x(double radians) { return Quat(Eigen::AngleAxisd(radians, Vec3::UnitX())); }
Quat about_y(double radians) { return Quat(Eigen::AngleAxisd(radians, Vec3::UnitY())); }
Quat about_z(double radians) { return Quat(Eigen::AngleAxisd(radians, Vec3::UnitZ())); }

/// Slow movements of one who stands: sums of sines that do not repeat soon.
struct Sway {
  double breath = 0.0;  ///< −1 … 1
  Vec3 pelvis = Vec3::Zero();
  double head_yaw = 0.0;
};

Sway sway_at(double seconds, double stillness) {
  const auto sine = [&](double hertz, double phase) {
    return std::sin(2.0 * pi * (hertz * seconds + phase));
  };
  Sway sway;
  sway.breath = sine(0.26, 0.0);
  // Of the order of quiet stance: some millimetres, now and then the weight goes to one leg.
  sway.pelvis = stillness * Vec3(0.009 * sine(0.071, 0.0) + 0.0025 * sine(0.31, 0.2), 0.0,
                                 0.004 * sine(0.113, 0.0) + 0.002 * sine(0.41, 0.6));
  sway.head_yaw = stillness * radians_per_degree * (2.5 * sine(0.053, 0.0) + 1.0 * sine(0.17, 0.0));
  return sway;
}

/// The body in the root's frame, without legs yet.
struct CarriedPelvis {
  Vec3 pelvis = Vec3::Zero();
  Quat rotation = Quat::Identity();  ///< of the pelvis
  Quat unlent = Quat::Identity();    ///< of the pelvis, without what it leans into curves
};

CarriedPelvis carried_pelvis(const SteeredMoment& moment, const SteeredWalk& walker,
                             const Sway& sway) {
  const PelvisPath& path = moment.legs[0].pelvis;
  const RootMotion& root = walker.root;
  const double sideways = root.speed.value * root.turning.value;  // m/s², to the left
  const double side_lean = std::clamp(0.045 * sideways, -0.12, 0.12);
  const double front_lean = std::clamp(0.03 * root.speed.rate, -0.06, 0.08);
  CarriedPelvis carried;
  carried.unlent = pelvis_rotation(path, walker.phase);
  carried.rotation = about_z(-side_lean) * about_x(front_lean) * carried.unlent;
  carried.pelvis = pelvis_position(path, walker.phase) + sway.pelvis;
  carried.pelvis.z() -= path.stride_m * walker.phase;
  carried.pelvis.x() += 0.5 * side_lean * path.mean_height_m;
  return carried;
}

/// Highest pelvis from which the leg reaches its foot.
double highest_pelvis(const LegCycle& leg, const CarriedPelvis& carried, const FootPose& foot) {
  const Vec3 hip = carried.pelvis + carried.rotation * leg.hip_offset;
  const double longest = leg_length_at(leg, radians_per_degree * least_knee_deg);
  const double across = std::hypot(hip.x() - foot.ankle.x(), hip.z() - foot.ankle.z());
  const double height = std::sqrt(std::max(0.01, longest * longest - across * across));
  return carried.pelvis.y() + foot.ankle.y() + height - hip.y();
}

LegMoment leg_moment(const SteeredMoment& moment, const SteeredWalk& walker, std::size_t side) {
  return {moment.legs[side], walker.root, walker.phase, walker.phase_rate};
}

std::array<FootPose, 2> feet_of(const SteeredMoment& moment, const SteeredWalk& walker) {
  std::array<FootPose, 2> feet;
  for (std::size_t side = 0; side < 2; ++side) {
    feet[side] = foot_of(walker.legs[side], leg_moment(moment, walker, side));
  }
  return feet;
}

/// The smaller of two numbers, rounded off over `soft`.
double softly_less(double a, double b, double soft) {
  const double low = std::min(a, b);
  return low - soft * std::log1p(std::exp(-(std::max(a, b) - low) / soft));
}

/// Draws a swinging foot towards the hip where the leg would be straighter than it may.
void pull_within_reach(const LegCycle& leg, const CarriedPelvis& carried, FootPose& foot) {
  constexpr double soft_m = 0.002;
  const Vec3 hip = carried.pelvis + carried.rotation * leg.hip_offset;
  const Vec3 line = foot.ankle - hip;
  const double longest = leg_length_at(leg, radians_per_degree * least_knee_deg) + soft_m;
  foot.ankle = hip + line * (softly_less(line.norm(), longest, soft_m) / line.norm());
}

/// Rotates a joint by a rotation in the root's frame.
void turn(const Skeleton& body, Pose& pose, BodyJoint joint, const Quat& rotation) {
  const Quat parent = world_transform(body, pose, body_parents[joint]).rotation;
  Quat& local = pose.rotations[static_cast<std::size_t>(joint)];
  local = parent.conjugate() * rotation * parent * local;
}

void breathe(const Sway& sway, Pose& pose) {
  const double lift = radians_per_degree * 0.7 * sway.breath;
  Quat& chest = pose.rotations[Chest];
  chest = chest * about_x(-lift);
  pose.rotations[Neck] = about_x(0.8 * lift) * pose.rotations[Neck];
  pose.rotations[LeftClavicle] = about_z(lift) * pose.rotations[LeftClavicle];
  pose.rotations[RightClavicle] = about_z(-lift) * pose.rotations[RightClavicle];
}

/// Distance by which the pelvis is too high for the leg, metres; negative if it can rise.
double out_of_reach(const LegCycle& leg, const CarriedPelvis& carried, const FootPose& foot) {
  return carried.pelvis.y() - highest_pelvis(leg, carried, foot);
}

/// `x` where it is large, 0 where it is small, rounded off over `soft`.
double softly_positive(double x, double soft) {
  return x > 30.0 * soft ? x : soft * std::log1p(std::exp(x / soft));
}

/// How far the shank leans over the foot, forward, radians: dorsiflexion of the flat foot.
double shank_lean(const LegCycle& leg, const CarriedPelvis& carried, const FootPose& foot) {
  const Vec3 line = carried.pelvis + carried.rotation * leg.hip_offset - foot.ankle;
  const double length = line.norm();
  const double knee = knee_flexion_at(leg, length);
  const double forward = line.x() * std::sin(foot.yaw) + line.z() * std::cos(foot.yaw);
  return std::atan2(forward, line.y()) +
         std::asin(std::clamp(leg.thigh_m * std::sin(knee) / length, -1.0, 1.0));
}

/// Rise of the heel with which a standing leg reaches its foot and its ankle need not bend too far.
double heel_rise_for(SteppingLeg leg, const LegMoment& moment, const CarriedPelvis& carried) {
  leg.heel_rise = {};
  const FootPose foot = foot_of(leg, moment);
  if (foot.pitch > 0.0) return 0.0;
  constexpr double soft_m = 0.002;
  constexpr double soft_angle = 0.03;
  const double reach = softly_positive(out_of_reach(moment.steady, carried, foot), soft_m) /
                       moment.steady.foot.ball.z();
  const double bend = shank_lean(moment.steady, carried, foot) + foot.pitch -
                      radians_per_degree * most_dorsiflexion_deg;
  return std::min(0.9, std::max(reach, softly_positive(bend, soft_angle)));
}

/// Bends the ankle of a foot in the air no further than ankles go: its toes sink.
void ease_ankle(const LegCycle& leg, const CarriedPelvis& carried, FootPose& foot) {
  constexpr double most_deg = 24.0;  // some 30° are healthy; 10° are usual in the swing of a walk
  constexpr double soft_angle = 0.05;
  const double bend = shank_lean(leg, carried, foot) + foot.pitch;
  foot.pitch -= softly_positive(bend - radians_per_degree * most_deg, soft_angle);
}

/// Leads a swinging foot round the standing one, which in a turn may stand in its way.
void pass_beside(const FootPose& standing, double side, double swing_share, FootPose& foot) {
  constexpr double apart_m = 0.085;  // of the ankles
  constexpr double along_m = 0.26;   // before and behind the standing foot, over which it gives way
  constexpr double soft_m = 0.015;
  const double along = (foot.ankle.z() - standing.ankle.z()) / along_m;
  const double beside = side * (foot.ankle.x() - standing.ankle.x());
  const double share = 16.0 * std::pow(swing_share * (1.0 - swing_share), 2.0);
  foot.ankle.x() +=
      side * share * softly_positive(apart_m * std::exp(-along * along) - beside, soft_m);
}

/// Predicted shortfall of a swinging leg at its landing, metres.
double missing_at_landing(const SteeredMoment& moment, const SteeredWalk& walker,
                          std::size_t side) {
  const SteppingLeg& leg = walker.legs[side];
  SteeredWalk then = walker;
  then.phase = leg.lands_at;
  return out_of_reach(moment.legs[side], carried_pelvis(moment, then, {}),
                      landing_foot(leg, leg_moment(moment, walker, side)));
}

Sway sway_of(const SteeredWalk& walker) {
  return sway_at(walker.seconds, std::max(0.0, 1.0 - walker.activity.value));
}

}  // namespace

void follow_reach(const SteeredMoment& moment, double seconds, SteeredWalk& walker) {
  const CarriedPelvis carried = carried_pelvis(moment, walker, sway_of(walker));
  CarriedPelvis sunken = carried;
  sunken.pelvis.y() -= walker.crouch.value;
  double missing = 0.0;
  for (std::size_t side = 0; side < 2; ++side) {
    SteppingLeg& leg = walker.legs[side];
    const LegMoment now = leg_moment(moment, walker, side);
    if (!leg.swinging) settle(leg, heel_rise_for(leg, now, sunken), seconds);
    missing =
        std::max(missing, leg.swinging ? missing_at_landing(moment, walker, side)
                                       : out_of_reach(now.steady, carried, foot_of(leg, now)));
  }
  constexpr double sinking = 12.0;  // 1/s
  constexpr double rising = 4.0;
  const double stiffness = missing > walker.crouch.value ? sinking : rising;
  walker.crouch = spring_step(walker.crouch, missing, stiffness, seconds);
}

Pose pose_of(const WalkerGaits& gaits, const SteeredWalk& walker) {
  const SteeredMoment moment = moment_at(gaits, walker);
  const Sway sway = sway_of(walker);
  CarriedPelvis carried = carried_pelvis(moment, walker, sway);
  std::array<FootPose, 2> feet = feet_of(moment, walker);
  double height = carried.pelvis.y() - walker.crouch.value;
  for (std::size_t side = 0; side < 2; ++side) {
    const SteppingLeg& leg = walker.legs[side];
    const double x = leg.swinging ? swing_share(leg, leg_moment(moment, walker, side)) : 0.0;
    const double free =
        20.0 * x * x * x * (1.0 - x) * (1.0 - x);  // metres: a foot in the air follows
    const double highest = highest_pelvis(moment.legs[side], carried, feet[side]);
    height = softly_less(height, highest + free, soft_reach_m);
  }
  carried.pelvis.y() = height;
  for (std::size_t side = 0; side < 2; ++side) {
    if (!walker.legs[side].swinging) continue;
    if (!walker.legs[1 - side].swinging) {
      const double share = swing_share(walker.legs[side], leg_moment(moment, walker, side));
      pass_beside(feet[1 - side], moment.legs[side].side, share, feet[side]);
    }
    pull_within_reach(moment.legs[side], carried, feet[side]);
    ease_ankle(moment.legs[side], carried, feet[side]);
  }

  Pose pose;
  pose.rotations.assign(body_joint_count, Quat::Identity());
  pose.root_position = carried.pelvis;
  set_upper_body(moment.upper, walker.phase, carried.unlent, pose);
  pose.rotations[Pelvis] = carried.rotation;
  breathe(sway, pose);
  const double gaze = walker.gaze.value;
  turn(gaits.body, pose, Chest, about_y(0.2 * gaze));
  turn(gaits.body, pose, Neck, about_y(0.3 * gaze));
  turn(gaits.body, pose, Head, about_y(0.5 * gaze + sway.head_yaw));
  for (std::size_t side = 0; side < 2; ++side) {
    set_leg(moment.legs[side], feet[side], gaits.body, pose);
  }
  pose.root_position = to_world(walker.root, pose.root_position);
  pose.rotations[Pelvis] = about_y(walker.root.heading) * pose.rotations[Pelvis];
  for (Quat& rotation : pose.rotations) {
    rotation = in_hemisphere_of(Quat::Identity(), rotation.normalized());
  }
  return pose;
}

}  // namespace mien::motion
