#pragma once

#include <string_view>
#include <vector>

#include "motion/skeleton/body.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

/// An anatomical joint angle and its range in healthy adults.
struct JointAngle {
  BodyJoint joint;
  std::string_view name;          ///< "flexion"
  double least_degrees;           ///< lower limit; −25 of flexion is 25° of extension
  double most_degrees;            ///< upper limit
  std::string_view beyond_least;  ///< description of values below the range: "is bent backwards"
  std::string_view beyond_most;   ///< the same for values above the range
  double most_free_degrees = most_degrees;  ///< upper limit without load; differs only for ankles
};

/// The angles that are checked, for both sides of the body. Ranges follow the norms of the American
/// Academy of Orthopaedic Surgeons (Greene and Heckman 1994), extended to those of flexible people.
const std::vector<JointAngle>& joint_angles();

/// The angle with a given joint and name, which must exist.
const JointAngle& joint_angle(BodyJoint joint, std::string_view name);

/// Maximum bend of a wrist in any direction.
inline constexpr double wrist_range_degrees = 80.0;

/// The values of all angles in a pose of the canonical body, degrees, in the order of
/// `joint_angles`. Angles of Head describe the head relative to the chest, those of Chest the chest
/// relative to the pelvis, and those of the shoulders the upper arm relative to the chest. Positive
/// shoulder extension is backward, positive shoulder adduction inward.
std::vector<double> measured_angles(const Pose& pose);

}  // namespace mien::motion
