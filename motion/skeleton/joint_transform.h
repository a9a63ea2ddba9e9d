#pragma once

#include "motion/skeleton/pose.h"

namespace mien::motion {

/// Where one joint is, and how it is turned, in world space.
struct JointTransform {
  Vec3 position;
  Quat rotation;
};

/// The same as `world_transforms` has for the joint, from the joints above it alone.
JointTransform world_transform(const Skeleton& skeleton, const Pose& pose, int joint);

}  // namespace mien::motion
