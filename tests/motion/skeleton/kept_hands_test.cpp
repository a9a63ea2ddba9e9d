#include <array>

#include <gtest/gtest.h>

#include "motion/dynamics/retiming.h"
#include "motion/gait/loop.h"
#include "motion/handed_motion.h"
#include "motion/interpolation/blend.h"
#include "motion/modify/limb_timing.h"
#include "motion/modify/nine_grid.h"
#include "motion/random_motion.h"
#include "motion/rig/retarget.h"
#include "motion/skeleton/finger_angles.h"
#include "motion/skeleton/mirror.h"
#include "motion/skeleton/recorded_hands.h"

// What is made of motions with fingers has them too.

namespace mien::motion {
namespace {

using namespace mien::test;

Example handed_loop(std::mt19937_64& random, int frames) {
  Example example = random_loop(random, frames);
  example.clip = with_moving_fingers(example.clip, random);
  return example;
}

TEST(KeptHands, AreTheSameAfterTwoMirrorsAndBendAsMuchInOne) {
  std::mt19937_64 random(1);
  const Clip clip = handed_loop(random, 30).clip;
  const Clip seen = mirrored(clip);
  const Clip twice = mirrored(seen);
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    for (int j = 0; j < finger_joint_count; ++j) {
      EXPECT_EQ(twice.poses[f].fingers[size_t(j)].coeffs(),
                clip.poses[f].fingers[size_t(j)].coeffs());
      const FingerAngles own = finger_angles(clip.poses[f], j);
      const FingerAngles image = finger_angles(seen.poses[f], mirrored_finger(j));
      EXPECT_NEAR(own.flexion, image.flexion, 1e-9);
      EXPECT_NEAR(std::abs(own.abduction), std::abs(image.abduction), 1e-9);
    }
  }
}

TEST(KeptHands, OfABlendOfOneMotionAreItsOwn) {
  std::mt19937_64 random(2);
  ExampleSet set;
  set.examples = {handed_loop(random, 30)};
  set.examples.push_back(set.examples.front());
  for (const RotationBlend how : {RotationBlend::karcher_mean, RotationBlend::direction_vectors,
                                  RotationBlend::markley_mean}) {
    const Example mean = blend(set, Eigen::Vector2d(0.3, 0.7), {30.0, how, WarpShape::monotone});
    for (size_t f = 0; f < mean.clip.poses.size(); ++f)
      EXPECT_LT(largest_finger_turn(mean.clip.poses[f], set.examples[0].clip.poses[f]), 1e-7);
  }
}

TEST(KeptHands, OfABlendAreBetweenThoseOfItsExamples) {
  std::mt19937_64 random(3);
  ExampleSet set;
  set.examples = {handed_loop(random, 30)};
  set.examples.push_back(set.examples.front());
  for (int e = 0; e < 2; ++e) {
    for (Pose& pose : set.examples[size_t(e)].clip.poses)
      for (int j = 0; j < finger_joint_count; ++j)
        pose.fingers[size_t(j)] = exp((e == 0 ? 0.2 : 1.0) * flexion_axis(j));
  }
  const Example mean = blend(set, Eigen::Vector2d(0.25, 0.75));
  for (const Pose& pose : mean.clip.poses)
    for (int j = 0; j < finger_joint_count; ++j)
      EXPECT_NEAR(finger_angles(pose, j).flexion, 0.8 / radians_per_degree, 1e-6);
}

TEST(KeptHands, AreLeftOutOfABlendOfWhichOneExampleHasNone) {
  std::mt19937_64 random(4);
  ExampleSet set;
  set.examples = {handed_loop(random, 30), random_loop(random, 30)};
  EXPECT_FALSE(has_fingers(blend(set, Eigen::Vector2d(0.5, 0.5)).clip));
  EXPECT_TRUE(has_fingers(blend(set, Eigen::Vector2d(1.0, 0.0)).clip));
}

TEST(KeptHands, CloseInALoop) {
  std::mt19937_64 random(5);
  Clip clip = handed_loop(random, 60).clip;
  clip.loops = false;
  for (size_t f = 0; f < clip.poses.size(); ++f)
    for (Quat& finger : clip.poses[f].fingers) finger = exp(Vec3(0, 0, 0.01 * double(f))) * finger;
  const Clip closed = closed_ends(clip, 5, 45);
  EXPECT_GT(largest_finger_turn(clip.poses[5], clip.poses[45]), 0.1);
  EXPECT_LT(largest_finger_turn(closed.poses.front(), closed.poses.back()), 1e-7);
  const Clip steps = mirrored_loop(clip, 5, 45);
  const Pose last = mirrored(steps.poses[size_t(steps.frame_count() / 2 - 1)]);
  const Pose end = mirrored(steps.poses.back());
  EXPECT_EQ(steps.frame_count(), 80);
  // From the end of each half to the start of the other it is no further than from frame to frame.
  EXPECT_LT(largest_finger_turn(mirrored(last), steps.poses[40]), 0.1);
  EXPECT_LT(largest_finger_turn(mirrored(end), steps.poses[0]), 0.1);
}

TEST(KeptHands, KeepTheirTimeWhenTheMotionIsResampledAndRetimed) {
  std::mt19937_64 random(6);
  const Clip clip = handed_loop(random, 60).clip;
  const Clip fine = resampled(clip, 120.0);
  EXPECT_LT(largest_finger_turn(fine.poses[80], clip.poses[20]), 1e-12);
  const Retiming slower = retiming(clip.frame_count(), true, Tempo{0.5}, {});
  const Clip slow = retimed(clip, slower);
  ASSERT_EQ(slow.frame_count(), 120);
  for (int f = 0; f < 60; ++f)
    EXPECT_LT(largest_finger_turn(slow.poses[size_t(2 * f)], clip.poses[size_t(f)]), 1e-9) << f;
}

TEST(KeptHands, GoAlongWithTheirHandAndNotWithTheOther) {
  std::mt19937_64 random(7);
  Clip clip = handed_loop(random, 30).clip;
  const Clip before = clip;
  std::vector<double> sources;
  for (int f = 0; f < 30; ++f) sources.push_back(f + 2.0);
  retime(clip, Limb::left_hand, sources);
  for (int f = 0; f < 30; ++f) {
    const Pose& later = before.poses[size_t((f + 2) % 30)];
    for (size_t j = 0; j < size_t(finger_joint_count); ++j) {
      const Pose& expected = is_left_finger(int(j)) ? later : before.poses[size_t(f)];
      EXPECT_LT(angle_between(clip.poses[size_t(f)].fingers[j], expected.fingers[j]), 1e-7);
    }
  }
}

TEST(KeptHands, AreBetweenThoseOfTheMotionsOfAMean) {
  std::mt19937_64 random(10);
  const Clip clip = handed_loop(random, 30).clip;
  std::array<Clip, 2> corners = {clip, clip};
  for (int e = 0; e < 2; ++e)
    for (Pose& pose : corners[size_t(e)].poses)
      for (int j = 0; j < finger_joint_count; ++j)
        pose.fingers[size_t(j)] = exp((e == 0 ? 0.2 : 1.0) * flexion_axis(j));
  const Clip mean = mean_clip(corners, std::array{0.5, 0.5});
  // A mean of direction vectors is not quite one of angles.
  for (const Pose& pose : mean.poses)
    for (int j = 0; j < finger_joint_count; ++j)
      EXPECT_NEAR(finger_angles(pose, j).flexion, 0.6 / radians_per_degree, 1.0);
}

TEST(KeptHands, KeepTheTimeOfTheirHandAtEveryAcceleration) {
  std::mt19937_64 random(11);
  Clip clip = handed_loop(random, 60).clip;
  // Fingers that do what the wrist does.
  for (Pose& pose : clip.poses)
    for (size_t j = 0; j < size_t(finger_joint_count); ++j)
      pose.fingers[j] = pose.rotations[is_left_finger(int(j)) ? LeftWrist : RightWrist];
  for (const double acceleration : {-0.6, 0.4, 1.0}) {
    Modification m;
    m.acceleration = acceleration;
    const Clip timed = grid_motion(clip, {}, m);
    for (const Pose& pose : timed.poses) {
      for (size_t j = 0; j < size_t(finger_joint_count); ++j) {
        const BodyJoint wrist = is_left_finger(int(j)) ? LeftWrist : RightWrist;
        EXPECT_LT(angle_between(pose.fingers[j], pose.rotations[wrist]), 0.05) << acceleration;
      }
    }
  }
}

TEST(KeptHands, AreThoseOfTheOtherBodyAfterRetargeting) {
  std::mt19937_64 random(8);
  const Clip clip = handed_loop(random, 30).clip;
  Skeleton body = clip.body;
  for (Joint& joint : body.joints) joint.offset *= 1.2;
  const Clip taller = retarget(clip, body);
  EXPECT_EQ(largest_finger_turn(taller.poses[9], clip.poses[9]), 0.0);
}

TEST(Fingertips, AreWhereForwardKinematicsOfTheWholeBodyHasThem) {
  std::mt19937_64 random(9);
  const Clip clip = handed_loop(random, 10).clip;
  const Skeleton handed = with_fingers(clip.body);
  for (const Pose& pose : clip.poses) {
    const JointTransforms world = world_transforms(handed, with_fingers(pose));
    const auto tips = fingertips(clip.body, pose);
    for (int tip = 0; tip < 2 * fingers_per_hand; ++tip) {
      const bool left = tip < fingers_per_hand;
      const int joint = body_joint_count + finger_joint(left, Finger(tip % fingers_per_hand), 2);
      const Vec3 place = world.positions[size_t(joint)] +
                         world.rotations[size_t(joint)] * *handed.joints[size_t(joint)].tip;
      const int wrist = left ? LeftWrist : RightWrist;
      const Vec3 seen =
          world.rotations[size_t(wrist)].conjugate() * (place - world.positions[size_t(wrist)]);
      EXPECT_LT((tips[size_t(tip)] - seen).norm(), 1e-12);
    }
  }
}

TEST(FingerAngles, AreThoseOfTheRotation) {
  Pose pose;
  for (int j = 0; j < finger_joint_count; ++j) {
    pose.fingers.assign(finger_joint_count, Quat::Identity());
    for (const double degrees : {-40.0, 0.0, 30.0, 89.0, 150.0}) {
      pose.fingers[size_t(j)] = exp(degrees * radians_per_degree * flexion_axis(j));
      EXPECT_NEAR(finger_angles(pose, j).flexion, degrees, 1e-9);
      EXPECT_NEAR(finger_angles(pose, j).abduction, 0.0, 1e-6);
    }
  }
  // A finger spread by 20° in the plane of the palm: about the palm's normal.
  pose.fingers.assign(finger_joint_count, exp(Vec3(0, 20 * radians_per_degree, 0)));
  const FingerAngles spread = finger_angles(pose, finger_joint(true, Finger::middle, 0));
  EXPECT_NEAR(spread.flexion, 0.0, 1e-9);
  EXPECT_NEAR(std::abs(spread.abduction), 20.0, 1e-9);
}

}  // namespace
}  // namespace mien::motion
