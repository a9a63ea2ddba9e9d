#pragma once

#include <string_view>
#include <vector>

#include "motion/skeleton/body.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

/// An anatomical joint angle and its range in healthy adults.
struct JointAngle {
  BodyJoint joint;
  std::string_view name;  ///< "flexion"
  double least_degrees;   ///< the opposite direction is negative: −25 is 25° of extension
  double most_degrees;
  std::string_view beyond_least;  ///< words for a value below the range: "is bent backwards"
  std::string_view beyond_most;
  double most_free_degrees = most_degrees;  ///< upper limit without load; differs for ankles only
};

/// The angles that are checked, for both sides of the body. Ranges after the norms of the American
/// Academy of Orthopaedic Surgeons (Greene and Heckman 1994), extended to the range of flexible
/// people.
const std::vector<JointAngle>& joint_angles();

/// The angle of that joint and name, which must exist.
const JointAngle& joint_angle(BodyJoint joint, std::string_view name);

/// Largest bend of a wrist in any direction.
inline constexpr double wrist_range_degrees = 80.0;

/// The values of all angles in a pose of the canonical body, degrees, in the order of
/// `joint_angles`. The neck angle is that of the head relative to the chest, the spine angle that
/// of the chest relative to the pelvis, the shoulder angle that of the upper arm relative to the
/// chest: positive extension is backward, positive adduction inward.
std::vector<double> measured_angles(const Pose& pose);

}  // namespace mien::motion
