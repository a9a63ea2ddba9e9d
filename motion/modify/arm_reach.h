#pragma once

#include "motion/skeleton/body.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

/// The joints of an arm of the canonical body.
struct Arm {
  BodyJoint clavicle, shoulder, elbow, wrist;
};

Arm arm_of(bool left);

/// The pose of the canonical body with a wrist moved by `shift`, metres, as far as the arm reaches
/// (98 % of its length, or as far as it did); the arm follows by inverse kinematics, a stretched
/// one bends about the axis of its elbow, and the hand keeps its orientation in the world.
Pose with_wrist_moved(const Skeleton& body, const Pose& pose, bool left, const Vec3& shift);

}  // namespace mien::motion
