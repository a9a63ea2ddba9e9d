#include "motion/procedural/walker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "motion/error.h"
#include "motion/math/rotation.h"
#include "motion/procedural/leg_cycle.h"
#include "motion/procedural/walk_curves.h"
#include "motion/procedural/walker_legs.h"

namespace mien::motion {

namespace {

struct Walker {
  PelvisPath pelvis;
  std::array<LegCycle, 2> legs;  ///< left, right
};

std::string rounded(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
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

Pose pose_of(const Walker& walker, double phase, const Skeleton& body) {
  Pose pose;
  pose.rotations.assign(body_joint_count, Quat::Identity());
  pose.root_position = pelvis_position(walker.pelvis, phase);
  pose.rotations[Pelvis] = pelvis_rotation(walker.pelvis, phase);
  set_upper_body(walker.pelvis.style, phase, pose.rotations[Pelvis], pose);
  for (const LegCycle& leg : walker.legs) set_leg(leg, foot_at(leg, phase), body, pose);
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

Quat turn_x(double degrees) {
  return Quat(Eigen::AngleAxisd(radians_per_degree * degrees, Vec3::UnitX()));
}
Quat turn_y(double degrees) {
  return Quat(Eigen::AngleAxisd(radians_per_degree * degrees, Vec3::UnitY()));
}
Quat turn_z(double degrees) {
  return Quat(Eigen::AngleAxisd(radians_per_degree * degrees, Vec3::UnitZ()));
}

/// The same turn on the other side of the body.
Quat mirrored_turn(const Quat& q) { return Quat(q.w(), q.x(), -q.y(), -q.z()); }

Quat& rotation(Pose& pose, BodyJoint joint) { return pose.rotations[static_cast<size_t>(joint)]; }

/// World rotations of the trunk's parts.
struct Trunk {
  Quat spine;
  Quat chest;
  Quat neck;
  Quat head;
  Quat hang;  ///< the frame the arms hang in: upright, half turned with the shoulders
};

Trunk trunk_at(const WalkStyle& style, double phase) {
  const double shoulders =
      -style.trunk_rotation_deg * shoulder_rotation_shape(phase, style.sharpness);
  const double sway = -style.trunk_sway_deg * wave(1, phase, 0.27);
  const double nod = 1.2 * wave(2, phase, 0.06);  // forward after each heel strike
  const double lean = style.trunk_lean_deg + nod;
  const double rise = wave(2, phase, 0.33);
  Trunk trunk;
  trunk.spine = turn_y(0.45 * shoulders) * turn_z(0.6 * sway) * turn_x(lean);
  trunk.chest = turn_y(shoulders) * turn_z(sway) * turn_x(lean + style.chest_flexion_deg);
  const double tilt = -style.head_sway_deg * wave(1, phase, 0.30);
  trunk.neck = turn_y(0.5 * shoulders) * turn_z(0.5 * (sway + tilt)) *
               turn_x(style.neck_flexion_deg + 0.5 * nod);
  trunk.head = turn_y(0.12 * shoulders) * turn_z(tilt) * turn_x(style.head_pitch_deg + 0.8 * rise);
  trunk.hang = turn_y(0.5 * shoulders);
  return trunk;
}

/// The joint rotations of one arm, as the left arm would have them.
struct Arm {
  Quat clavicle;  ///< local
  Quat shoulder;  ///< in the frame the arm hangs in
  Quat elbow;     ///< local
  Quat wrist;     ///< local
};

Arm arm_at(const WalkStyle& style, double phase) {
  const double late = phase - style.arm_lag_share;
  const double later = late - 0.6 * style.arm_lag_share;
  const double swing = arm_swing_shape(phase, style.sharpness);
  const double flexion = style.arm_flexion_deg + 0.5 * style.arm_swing_deg * swing;
  const double abduction = style.arm_abduction_deg + 0.06 * style.arm_swing_deg * swing;
  const double elbow =
      style.elbow_flexion_deg + 0.5 * style.elbow_swing_deg * elbow_shape(late, style.sharpness);
  const double wrist =
      style.wrist_flexion_deg - 0.5 * style.wrist_swing_deg * arm_swing_shape(later, 0.0);
  Arm arm;
  arm.clavicle = turn_y(-(style.shoulder_protraction_deg + 0.08 * style.arm_swing_deg * swing)) *
                 turn_z(style.shoulder_elevation_deg);
  // The hand swings forward across the body and back away from it.
  const double inward = style.arm_rotation_deg + 0.2 * style.elbow_swing_deg * swing;
  arm.shoulder = turn_x(-flexion) * turn_z(-(90.0 - abduction)) * turn_x(inward);
  constexpr double carrying_angle = 10.0;  // the hanging forearm points away from the hip
  arm.elbow = turn_y(-elbow) * turn_z(carrying_angle) * turn_x(style.forearm_pronation_deg);
  arm.wrist = turn_z(-wrist);
  return arm;
}

void set_arm(const Arm& arm, const Trunk& trunk, bool left, Pose& pose) {
  const auto sided = [left](const Quat& q) { return left ? q : mirrored_turn(q); };
  const BodyJoint first = left ? LeftClavicle : RightClavicle;
  const Quat clavicle = sided(arm.clavicle);
  rotation(pose, first) = clavicle;
  rotation(pose, BodyJoint(first + 1)) =
      (trunk.chest * clavicle).conjugate() * trunk.hang * sided(arm.shoulder);
  rotation(pose, BodyJoint(first + 2)) = sided(arm.elbow);
  rotation(pose, BodyJoint(first + 3)) = sided(arm.wrist);
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

void set_upper_body(const WalkStyle& style, double phase, const Quat& pelvis_rotation, Pose& pose) {
  const Trunk trunk = trunk_at(style, phase);
  rotation(pose, Spine) = pelvis_rotation.conjugate() * trunk.spine;
  rotation(pose, Chest) = trunk.spine.conjugate() * trunk.chest;
  rotation(pose, Neck) = trunk.chest.conjugate() * trunk.neck;
  rotation(pose, Head) = trunk.neck.conjugate() * trunk.head;
  set_arm(arm_at(style, phase), trunk, true, pose);
  set_arm(arm_at(style, phase - 0.5), trunk, false, pose);
}

}  // namespace mien::motion
