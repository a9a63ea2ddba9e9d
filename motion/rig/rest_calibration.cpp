#include "motion/rig/rest_calibration.h"

#include <cmath>

#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

/// The zero pose, seen from its own left, up and forward.
struct RestFigure {
  const RigMotion& motion;
  JointTransforms pose;
  Quat facing;  ///< canonical axes → axes of the zero pose

  bool has(BodyJoint joint) const { return motion.has(joint); }

  /// Position in canonical axes.
  Vec3 point(BodyJoint joint) const { return facing.conjugate() * motion.point(pose, joint); }
};

/// The axis-aligned rotation nearby, or the rotation itself when there is none within 15° an axis.
Quat squared_up(const Quat& rotation) {
  const Mat3 m = rotation.toRotationMatrix();
  Mat3 square = Mat3::Zero();
  for (int column = 0; column < 3; ++column) {
    int largest = 0;
    if (m.col(column).cwiseAbs().maxCoeff(&largest) < std::cos(15 * radians_per_degree)) {
      return rotation;
    }
    square(largest, column) = m(largest, column) < 0 ? -1.0 : 1.0;
  }
  return std::abs(square.determinant() - 1.0) < 1e-9 ? Quat(square) : rotation;
}

std::optional<RestFigure> rest_figure(const RigMotion& motion) {
  RestFigure figure{motion, zero_pose(motion.rig), Quat::Identity()};
  const Vec3 left = motion.point(figure.pose, LeftHip) - motion.point(figure.pose, RightHip);
  const Vec3 hips =
      0.5 * (motion.point(figure.pose, LeftHip) + motion.point(figure.pose, RightHip));
  const Vec3 shoulders =
      0.5 * (motion.point(figure.pose, LeftShoulder) + motion.point(figure.pose, RightShoulder));
  const Vec3 up = shoulders - hips;
  const double size = leg_length(motion);
  if (left.norm() < 0.02 * size || left.cross(up).norm() < 0.1 * left.norm() * size) {
    return std::nullopt;
  }
  figure.facing = squared_up(frame_from(left, up));
  return figure;
}

bool points_along(const Vec3& bone, const Vec3& direction, double degrees) {
  return bone.norm() > 0 &&
         bone.normalized().dot(direction) > std::cos(degrees * radians_per_degree);
}

bool leg_is_in_place(const RestFigure& figure, BodyJoint hip) {
  const Vec3 thigh = figure.point(BodyJoint(hip + 1)) - figure.point(hip);
  const Vec3 shank = figure.point(BodyJoint(hip + 2)) - figure.point(BodyJoint(hip + 1));
  if (!points_along(thigh, -Vec3::UnitY(), 40) || !points_along(shank, -Vec3::UnitY(), 40)) {
    return false;
  }
  const auto toe = BodyJoint(hip + 3);
  return !figure.has(toe) ||
         points_along(figure.point(toe) - figure.point(BodyJoint(hip + 2)), Vec3::UnitZ(), 70);
}

bool arm_is_in_place(const RestFigure& figure, BodyJoint shoulder) {
  const Vec3 outward = rest_direction(shoulder);
  const Vec3 upper = figure.point(BodyJoint(shoulder + 1)) - figure.point(shoulder);
  const bool raised_or_hanging =
      std::abs(upper.normalized().z()) < std::sin(30 * radians_per_degree) &&
      upper.y() < 0.5 * upper.norm() && upper.dot(outward) > -0.3 * upper.norm();
  const auto wrist = BodyJoint(shoulder + 2);
  return raised_or_hanging &&
         (!figure.has(wrist) ||
          points_along(figure.point(wrist) - figure.point(BodyJoint(shoulder + 1)),
                       upper.normalized(), 50));
}

bool stands(const RestFigure& figure) {
  return leg_is_in_place(figure, LeftHip) && leg_is_in_place(figure, RightHip) &&
         arm_is_in_place(figure, LeftShoulder) && arm_is_in_place(figure, RightShoulder);
}

/// Direction of the joint's bone in canonical axes; its rest direction where the rig has no length.
Vec3 bone_direction(const RestFigure& figure, BodyJoint joint) {
  const double shortest = 0.02 * leg_length(figure.motion);
  for (auto next = next_present(figure.motion, joint); next;
       next = next_present(figure.motion, *next)) {
    const Vec3 bone = figure.point(*next) - figure.point(joint);
    if (bone.norm() > shortest) return bone.normalized();
  }
  return rest_direction(joint);
}

/// A sole lies square to its shank, so that spread legs stand flat when they come together, and is
/// turned to where the toes point.
Quat foot_frame(const RestFigure& figure, BodyJoint ankle) {
  const auto toe = BodyJoint(ankle + 1);
  const auto knee = BodyJoint(ankle - 1);
  const Quat spread = turn_between(rest_direction(knee), bone_direction(figure, knee));
  if (!figure.has(toe)) return spread;
  return spread * heading(spread.conjugate() * (figure.point(toe) - figure.point(ankle)));
}

Quat canonical_frame(const RestFigure& figure, BodyJoint joint) {
  const auto above = BodyJoint(joint - 1);
  if (joint == LeftAnkle || joint == RightAnkle) return foot_frame(figure, joint);
  if (joint == LeftToe || joint == RightToe) return foot_frame(figure, above);
  if (joint == LeftWrist || joint == RightWrist) return canonical_frame(figure, above);
  if (joint == Head) return Quat::Identity();
  return turn_between(rest_direction(joint), bone_direction(figure, joint));
}

}  // namespace

std::optional<std::array<Quat, body_joint_count>> rest_calibration(const RigMotion& motion) {
  const std::optional<RestFigure> figure = rest_figure(motion);
  if (!figure || !stands(*figure)) return std::nullopt;
  std::array<Quat, body_joint_count> constants;
  constants.fill(Quat::Identity());
  for (int j = 0; j < body_joint_count; ++j) {
    const auto joint = BodyJoint(j);
    if (!motion.turns(joint)) continue;
    constants[j] = motion.rotation(figure->pose, joint).conjugate() * figure->facing *
                   canonical_frame(*figure, joint);
  }
  return constants;
}

}  // namespace mien::motion
