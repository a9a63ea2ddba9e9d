#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "motion/math/rotation.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/clip.h"

namespace mien::test {

// Faults that people see and that are small, put into a motion.

using namespace mien::motion;

/// In one frame alone, the joint is rotated by `degrees` about `axis` (of its parent).
inline void twitch(Clip& clip, BodyJoint joint, int frame, double degrees, const Vec3& axis) {
  const Quat turn(Eigen::AngleAxisd(degrees * radians_per_degree, axis.normalized()));
  Quat& rotation = clip.poses[frame].rotations[joint];
  rotation = (turn * rotation).normalized();
}

/// An axis across the bone from `joint` to `child` in the frame, so that the rotation moves it.
inline Vec3 axis_across(const Clip& clip, BodyJoint joint, BodyJoint child, int frame,
                        std::mt19937_64& random) {
  const Vec3 along = clip.poses[frame].rotations[joint] * clip.body.joints[child].offset;
  std::normal_distribution<double> normal;
  const Vec3 any(normal(random), normal(random), normal(random));
  return (any - any.dot(along) / along.squaredNorm() * along).normalized();
}

/// White noise of the joint's rotation with a standard deviation of `degrees` about each axis.
inline void add_jitter(Clip& clip, BodyJoint joint, double degrees, std::mt19937_64& random) {
  std::normal_distribution<double> noise(0.0, degrees * radians_per_degree);
  for (Pose& pose : clip.poses) {
    const Vec3 turn(noise(random), noise(random), noise(random));
    pose.rotations[joint] = (exp(turn) * pose.rotations[joint]).normalized();
  }
}

/// The arm stays as it is in the first frame.
inline void stop_arm(Clip& clip, bool left) {
  for (const BodyJoint joint : {LeftShoulder, LeftElbow, LeftWrist}) {
    const BodyJoint own = left ? joint : mirrored(joint);
    for (Pose& pose : clip.poses) pose.rotations[own] = clip.poses[0].rotations[own];
  }
}

/// The upper arm is turned about its own axis by `degrees`, and with it the forearm.
inline void turn_upper_arm(Clip& clip, bool left, double degrees) {
  const BodyJoint shoulder = left ? LeftShoulder : RightShoulder;
  const BodyJoint elbow = left ? LeftElbow : RightElbow;
  const Vec3 along = clip.body.joints[elbow].offset.normalized();
  const Quat turn(Eigen::AngleAxisd(degrees * radians_per_degree, along));
  for (Pose& pose : clip.poses) {
    pose.rotations[shoulder] = (pose.rotations[shoulder] * turn).normalized();
  }
}

}  // namespace mien::test
