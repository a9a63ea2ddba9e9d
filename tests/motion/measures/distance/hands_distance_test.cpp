#include "motion/measures/distance/hands_distance.h"

#include <gtest/gtest.h>

#include "motion/handed_motion.h"
#include "motion/random_motion.h"
#include "motion/skeleton/hand_tip.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(HandsDistance, IsNoneWithoutFingersAndZeroBetweenTheSame) {
  std::mt19937_64 random(1);
  const Example bare = random_loop(random, 30);
  Example handed = bare;
  handed.clip = with_moving_fingers(bare.clip, random);
  EXPECT_FALSE(hands_distance(bare, bare));
  EXPECT_FALSE(hands_distance(bare, handed));
  ASSERT_TRUE(hands_distance(handed, handed));
  EXPECT_LT(*hands_distance(handed, handed), 1e-12);
}

TEST(HandsDistance, IsTheChordOfABentFingertipAndLeavesDAsItIs) {
  std::mt19937_64 random(2);
  Example straight = random_loop(random, 30);
  for (Pose& pose : straight.clip.poses) pose.fingers.assign(finger_joint_count, Quat::Identity());
  Example bent = straight;
  const int joint = finger_joint(true, Finger::middle, 2);
  for (Pose& pose : bent.clip.poses)
    pose.fingers[size_t(joint)] = exp(0.5 * pi * flexion_axis(joint));
  const double bone =
      fingertip_offset(true, Finger::middle, hand_length(straight.clip.body)).norm();
  ASSERT_TRUE(hands_distance(straight, bent));
  EXPECT_NEAR(*hands_distance(straight, bent), std::sqrt(2.0) * bone / 10.0, 1e-12);
  EXPECT_NEAR(*hands_distance(bent, straight), *hands_distance(straight, bent), 1e-12);
  EXPECT_LT(distance(straight, bent).mean, 1e-12);
}

TEST(HandsDistance, DoesNotCountHowTheHandsAreHeld) {
  std::mt19937_64 random(3);
  Example one = random_loop(random, 30);
  one.clip = with_moving_fingers(one.clip, random);
  Example other = one;
  for (Pose& pose : other.clip.poses) {
    pose.rotations[LeftWrist] = exp(Vec3(0.5, 0.3, 0.1)) * pose.rotations[LeftWrist];
    pose.rotations[RightShoulder] = exp(Vec3(0.5, 0.3, 0.1)) * pose.rotations[RightShoulder];
  }
  EXPECT_GT(distance(one, other).mean, 0.01);
  EXPECT_LT(*hands_distance(one, other), 1e-12);
}

}  // namespace
}  // namespace mien::motion
