#include "motion/modify/arm_reach.h"

#include <algorithm>

#include "motion/skeleton/two_bone_ik.h"

namespace mien::motion {

namespace {

constexpr double longest_reach = 0.98;  // of the arm's length

}  // namespace

Arm arm_of(bool left) {
  return left ? Arm{LeftClavicle, LeftShoulder, LeftElbow, LeftWrist}
              : Arm{RightClavicle, RightShoulder, RightElbow, RightWrist};
}

Pose with_wrist_moved(const Skeleton& body, const Pose& pose, bool left, const Vec3& shift) {
  const Arm arm = arm_of(left);
  const JointTransforms world = world_transforms(body, pose);
  const TwoBoneLimb limb = {world.positions[arm.shoulder], world.positions[arm.elbow],
                            world.positions[arm.wrist]};
  // An elbow bends about its own axis, which a stretched arm has too.
  const Vec3 hint = world.rotations[arm.shoulder] * -Vec3::UnitZ();
  const double length = (limb.middle - limb.root).norm() + (limb.end - limb.middle).norm();
  const double reach = std::max(longest_reach, (limb.end - limb.root).norm() / length);
  const TwoBoneSolution solved = solve_two_bone(limb, limb.end + shift, hint, reach);
  const Quat upper = solved.upper_turn * world.rotations[arm.shoulder];
  const Quat lower = solved.lower_turn * world.rotations[arm.elbow];
  Pose result = pose;
  result.rotations[arm.shoulder] = (world.rotations[arm.clavicle].conjugate() * upper).normalized();
  result.rotations[arm.elbow] = (upper.conjugate() * lower).normalized();
  result.rotations[arm.wrist] = (lower.conjugate() * world.rotations[arm.wrist]).normalized();
  return result;
}

}  // namespace mien::motion
