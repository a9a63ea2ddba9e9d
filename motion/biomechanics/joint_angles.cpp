#include "motion/biomechanics/joint_angles.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

double degrees(double radians) { return radians / radians_per_degree; }

/// Turn about the bone, degrees, of a rotation whose bone rests along `bone`.
double twist(const Quat& rotation, const Vec3& bone) {
  return degrees(log(twist_about(rotation, bone)).dot(bone));
}

/// A bone that hangs down at rest, seen from its parent: forward of down and outward, degrees.
struct Hanging {
  double forward;
  double outward;
};

Hanging hanging(const Quat& rotation, double side) {
  const Vec3 bone = rotation * -Vec3::UnitY();
  return {degrees(std::atan2(bone.z(), -bone.y())),
          degrees(std::asin(std::clamp(side * bone.x(), -1.0, 1.0)))};
}

/// A bone that stands up at rest, seen from below: forward of up and to the left, degrees.
Hanging upright(const Quat& rotation) {
  const Vec3 bone = rotation * Vec3::UnitY();
  return {degrees(std::atan2(bone.z(), bone.y())),
          degrees(std::asin(std::clamp(bone.x(), -1.0, 1.0)))};
}

double arm_flexion(const Quat& elbow, double side) {
  const Vec3 forearm = elbow * Vec3(side, 0, 0);
  return degrees(std::atan2(forearm.z(), side * forearm.x()));
}

/// How far a bone points towards `direction` beyond the plane across it, degrees.
double towards(const Vec3& bone, const Vec3& direction) {
  return degrees(std::asin(std::clamp(bone.dot(direction), -1.0, 1.0)));
}

/// Toes up, degrees, of a foot that points forward at rest.
double toes_up(const Quat& ankle) {
  const Vec3 foot = ankle * Vec3::UnitZ();
  return degrees(std::atan2(foot.y(), std::hypot(foot.x(), foot.z())));
}

void measure_trunk(const Pose& pose, std::vector<double>& values) {
  const Quat spine = pose.rotations[Spine] * pose.rotations[Chest];
  const Quat neck = pose.rotations[Neck] * pose.rotations[Head];
  for (const Quat& bend : {spine, neck}) {
    const auto [forward, left] = upright(bend);
    values.insert(values.end(), {forward, std::abs(left), std::abs(twist(bend, Vec3::UnitY()))});
  }
}

void measure_side(const Pose& pose, bool is_left, std::vector<double>& values) {
  const double side = is_left ? 1.0 : -1.0;
  const auto turn = [&](BodyJoint left) { return pose.rotations[is_left ? left : mirrored(left)]; };
  const Vec3 upper_arm = turn(LeftClavicle) * turn(LeftShoulder) * Vec3(side, 0, 0);
  values.push_back(towards(upper_arm, -Vec3::UnitZ()));
  values.push_back(towards(upper_arm, Vec3(-side, 0, 0)));
  values.push_back(arm_flexion(turn(LeftElbow), side));
  const auto [forward, outward] = hanging(turn(LeftHip), side);
  values.push_back(forward);
  values.push_back(outward);
  values.push_back(std::abs(twist(turn(LeftHip), Vec3::UnitY())));
  const auto [shank, sideways] = hanging(turn(LeftKnee), side);
  values.push_back(-shank);
  values.push_back(std::abs(sideways));
  values.push_back(toes_up(turn(LeftAnkle)));
}

std::vector<JointAngle> all_angles() {
  std::vector<JointAngle> angles = {
      {Chest, "flexion", -30, 75, "is bent too far back", "is bent too far forward"},
      {Chest, "lateral flexion", 0, 40, "", "is bent too far sideways"},
      {Chest, "rotation", 0, 45, "", "is twisted too far"},
      {Head, "flexion", -60, 50, "is laid too far back", "is lowered too far"},
      {Head, "lateral flexion", 0, 45, "", "is tilted too far"},
      {Head, "rotation", 0, 80, "", "is turned too far"},
  };
  const std::vector<JointAngle> side = {
      {LeftShoulder, "extension", -90, 60, "", "is stretched too far back"},
      {LeftShoulder, "adduction", -90, 55, "", "crosses the body too far"},
      {LeftElbow, "flexion", 0, 150, "is bent backwards", "is bent too far"},
      {LeftHip, "flexion", -25, 125, "is stretched too far back", "is bent too far"},
      {LeftHip, "abduction", -30, 45, "is crossed too far", "is spread too far"},
      {LeftHip, "rotation", 0, 45, "", "is twisted too far"},
      {LeftKnee, "flexion", 0, 145, "is bent backwards", "is bent too far"},
      {LeftKnee, "sideways bend", 0, 15, "", "is bent sideways"},
      {LeftAnkle, "dorsiflexion", -50, 35, "is stretched too far", "is bent too far", 25},
  };
  angles.insert(angles.end(), side.begin(), side.end());
  for (JointAngle angle : side) {
    angle.joint = mirrored(angle.joint);
    angles.push_back(angle);
  }
  return angles;
}

}  // namespace

const std::vector<JointAngle>& joint_angles() {
  static const std::vector<JointAngle> angles = all_angles();
  return angles;
}

const JointAngle& joint_angle(BodyJoint joint, std::string_view name) {
  const auto found = std::find_if(
      joint_angles().begin(), joint_angles().end(),
      [&](const JointAngle& angle) { return angle.joint == joint && angle.name == name; });
  assert(found != joint_angles().end());
  return *found;
}

std::vector<double> measured_angles(const Pose& pose) {
  std::vector<double> values;
  values.reserve(joint_angles().size());
  measure_trunk(pose, values);
  measure_side(pose, true, values);
  measure_side(pose, false, values);
  return values;
}

}  // namespace mien::motion
