#include "motion/procedural/upper_body.h"

#include "motion/procedural/walk_curves.h"
#include "motion/skeleton/body.h"

namespace mien::motion {

namespace {

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
