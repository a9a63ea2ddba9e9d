#include "motion/modify/arm_reach.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "motion/math/rotation.h"
#include "motion/modify/posture.h"

namespace mien::motion {
namespace {

/// A raised arm whose elbow is bent about its own axis and, as measured ones, sideways.
Pose raised_arm(bool left, double flexion_degrees, double sideways_degrees) {
  Pose pose = standing_pose(standard_body());
  const Arm arm = arm_of(left);
  const double side = left ? 1.0 : -1.0;
  pose.rotations[arm.shoulder] = exp(Vec3(0.2, -0.5 * side, 0.9 * side));
  pose.rotations[arm.elbow] = exp(radians_per_degree * Vec3(0.0, -flexion_degrees * side, 0.0)) *
                              exp(radians_per_degree * Vec3(0.0, 0.0, sideways_degrees));
  return pose;
}

Vec3 elbow_of(const Pose& pose, bool left) {
  return world_positions(standard_body(), pose)[static_cast<size_t>(arm_of(left).elbow)];
}

/// From the shoulder to the wrist.
Vec3 reach_of(const Pose& pose, bool left) {
  const std::vector<Vec3> places = world_positions(standard_body(), pose);
  const Arm arm = arm_of(left);
  return places[static_cast<size_t>(arm.wrist)] - places[static_cast<size_t>(arm.shoulder)];
}

TEST(ArmReach, BendsAStretchedArmAboutTheAxisOfItsElbow) {
  for (const bool left : {true, false}) {
    const Vec3 inwards = -0.12 * reach_of(raised_arm(left, 0.0, 0.0), left).normalized();
    const Vec3 expected = elbow_of(
        with_wrist_moved(standard_body(), raised_arm(left, 12.0, 0.0), left, inwards), left);
    // What little a stretched elbow is bent to the side says nothing of where it bends to.
    for (const double flexion : {0.1, 1.0, 3.0}) {
      for (const double sideways : {-1.0, -0.3, 0.3, 1.0}) {
        const Pose moved =
            with_wrist_moved(standard_body(), raised_arm(left, flexion, sideways), left, inwards);
        EXPECT_LT((elbow_of(moved, left) - expected).norm(), 0.05)
            << left << " " << flexion << " " << sideways;
      }
    }
  }
}

TEST(ArmReach, LeavesHandsWhereTheyAreThatDoNotMove) {
  for (const double flexion : {4.0, 15.0, 40.0}) {
    const Pose pose = raised_arm(true, flexion, 0.5);
    const Pose same = with_wrist_moved(standard_body(), pose, true, Vec3::Zero());
    EXPECT_LT((elbow_of(same, true) - elbow_of(pose, true)).norm(), 1e-3) << flexion;
    EXPECT_LT((reach_of(same, true) - reach_of(pose, true)).norm(), 1e-5) << flexion;
  }
}

TEST(ArmReach, MovesTheWristAndKeepsTheHandsOrientation) {
  const Pose pose = raised_arm(false, 60.0, 0.0);
  const Vec3 shift(0.03, -0.08, 0.05);
  const Pose moved = with_wrist_moved(standard_body(), pose, false, shift);
  EXPECT_LT((reach_of(moved, false) - reach_of(pose, false) - shift).norm(), 1e-9);
  const auto wrist = static_cast<size_t>(RightWrist);
  EXPECT_LT(angle_between(world_transforms(standard_body(), moved).rotations[wrist],
                          world_transforms(standard_body(), pose).rotations[wrist]),
            1e-6);
}

}  // namespace
}  // namespace mien::motion
