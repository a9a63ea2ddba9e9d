#pragma once

#include <string_view>
#include <vector>

#include "motion/skeleton/body.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

/// An angle of a joint in words of anatomy, and the range that healthy adults have.
struct JointAngle {
  BodyJoint joint;
  std::string_view name;  ///< "flexion"
  double least_degrees;   ///< the other way is negative: −25 is 25° of extension
  double most_degrees;
  std::string_view beyond_least;  ///< what the joint does then: "is bent backwards"
  std::string_view beyond_most;
  double most_free_degrees = most_degrees;  ///< without load, which only ankles tell apart
};

/// The angles that are looked at, both sides of the body. Ranges after the norms of the American
/// Academy of Orthopaedic Surgeons (Greene and Heckman 1994), rounded up to what limber people
/// reach.
const std::vector<JointAngle>& joint_angles();

/// The angle of that joint and name, which must be one of them.
const JointAngle& joint_angle(BodyJoint joint, std::string_view name);

/// How far a wrist bends any way.
inline constexpr double wrist_range_degrees = 80.0;

/// Their values in a pose of the canonical body, degrees, in the order of `joint_angles`. The neck
/// is the head against the chest, the spine the chest against the pelvis, the shoulder the upper
/// arm against the chest: extension is how far it points backward, adduction how far inward.
std::vector<double> measured_angles(const Pose& pose);

}  // namespace mien::motion
