#include "motion/biomechanics/people_contact.h"

#include <gtest/gtest.h>

#include "motion/math/geometry.h"
#include "motion/skeleton/body.h"

namespace mien::motion {
namespace {

/// Somebody who stands, and passes through x = 0 at 0.1 m per frame from `from` on.
Clip sliding(double from, double z = 0.0) {
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = 10.0;
  for (int frame = 0; frame < 21; ++frame) {
    Pose pose;
    pose.root_position = {from + 0.1 * frame, 0.95, z};
    pose.rotations.assign(clip.body.joints.size(), Quat::Identity());
    clip.poses.push_back(pose);
  }
  return clip;
}

Clip standing(double x, double z) {
  Clip clip = sliding(0.0);
  for (Pose& pose : clip.poses) pose.root_position = {x, 0.95, z};
  return clip;
}

TEST(PeopleOverlaps, AreFoundWhileOneWalksThroughTheOther) {
  // In front of the other's chest at first, inside around frame 10, behind it at last.
  Clip through = sliding(0.0);
  for (Pose& pose : through.poses) std::swap(pose.root_position.x(), pose.root_position.z());
  for (Pose& pose : through.poses) pose.root_position.z() -= 1.0;
  const auto overlaps = people_overlaps(standing(0.0, 0.0), through, 0.03);
  ASSERT_EQ(overlaps.size(), 1u);
  EXPECT_LT(overlaps[0].first, 10);
  EXPECT_GT(overlaps[0].first, 4);
  EXPECT_EQ(overlaps[0].first + overlaps[0].last, 20);
  // At the moment at which both are at one place, all of the trunk is in the other.
  EXPECT_GT(overlaps[0].depth_m, 0.15);
  EXPECT_FALSE(overlaps[0].part.empty());
  const auto reversed = people_overlaps(through, standing(0.0, 0.0), 0.03);
  ASSERT_EQ(reversed.size(), 1u);
  EXPECT_DOUBLE_EQ(reversed[0].depth_m, overlaps[0].depth_m);
}

TEST(PeopleOverlaps, AreNoneOfPeopleBesideEachOther) {
  EXPECT_TRUE(people_overlaps(standing(0.0, 0.0), standing(0.0, 0.6), 0.03).empty());
}

/// The pose with the right arm straight ahead.
Clip reaching() {
  Clip clip = standing(0.0, 0.0);
  const Vec3 arm = clip.body.joints[RightElbow].offset.normalized();
  for (Pose& pose : clip.poses)
    pose.rotations[RightShoulder] = Quat::FromTwoVectors(arm, Vec3::UnitZ());
  return clip;
}

TEST(PeopleOverlaps, AllowHandsAndForearmsToTouch) {
  const Clip one = reaching();
  const Vec3 hand = world_transforms(one.body, one.poses[0]).positions[RightWrist];
  Clip other = one;
  const Quat turn(Eigen::AngleAxisd(pi, Vec3::UnitY()));
  for (Pose& pose : other.poses) {
    pose.root_position = hand + turn * (pose.root_position - hand);
    pose.rotations[0] = turn;
  }
  EXPECT_TRUE(people_overlaps(one, other, 0.03).empty());
  EXPECT_LT(nearest_hands(one, other).distance_m, 1e-9);
  // Nearer by half a metre, the hand is in the other's body.
  for (Pose& pose : other.poses) pose.root_position.z() -= 0.5;
  EXPECT_FALSE(people_overlaps(one, other, 0.03).empty());
}

TEST(NearestHands, AreFoundAtTheirMoment) {
  Clip passing = sliding(-1.5, 0.8);
  const NearestHands nearest = nearest_hands(standing(0.0, 0.0), passing);
  const Clip there = standing(0.0, 0.0);
  double least = 1e9;
  int frame = 0;
  for (int f = 0; f < passing.frame_count(); ++f) {
    const auto a = world_transforms(there.body, there.poses[0]).positions;
    const auto b =
        world_transforms(passing.body, passing.poses[static_cast<std::size_t>(f)]).positions;
    for (const BodyJoint own : {LeftWrist, RightWrist})
      for (const BodyJoint other : {LeftWrist, RightWrist})
        if ((a[own] - b[other]).norm() < least) {
          least = (a[own] - b[other]).norm();
          frame = f;
        }
  }
  EXPECT_LE(nearest.distance_m, least);
  EXPECT_NEAR(nearest.distance_m, least, 0.1);
  EXPECT_LE(std::abs(nearest.frame - frame), 2);
}

}  // namespace
}  // namespace mien::motion
