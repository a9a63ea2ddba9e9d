#include "motion/gestures/acting_hand.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/arm_motions.h"
#include "motion/math/rotation.h"
#include "motion/procedural/knock.h"
#include "motion/procedural/walker.h"
#include "motion/skeleton/hand_tip.h"
#include "motion/skeleton/mirror.h"

namespace mien::motion {
namespace {

TEST(ActingHand, IsTheOneThatKnocksOncePerStroke) {
  for (const int knocks : {3, 5}) {
    KnockStyle style;
    style.knocks = knocks;
    const Clip clip = knock(style, 60.0, standard_body()).clip;
    const auto gesture = acting_hand(clip);
    ASSERT_TRUE(gesture);
    EXPECT_FALSE(gesture->left);
    EXPECT_EQ(gesture->strokes.size(), static_cast<size_t>(knocks));
    for (size_t i = 1; i < gesture->strokes.size(); ++i)
      EXPECT_NEAR((gesture->strokes[i] - gesture->strokes[i - 1]) / 60.0, style.knock_seconds,
                  0.05);
    const auto of_mirrored = acting_hand(mirrored(clip));
    ASSERT_TRUE(of_mirrored);
    EXPECT_TRUE(of_mirrored->left);
    EXPECT_EQ(of_mirrored->strokes.size(), gesture->strokes.size());
  }
}

TEST(ActingHand, RisesFromWhereTheArmHangs) {
  const Clip clip = knock({}, 30.0, standard_body()).clip;
  const auto gesture = acting_hand(clip);
  ASSERT_TRUE(gesture);
  EXPECT_LT(gesture->away.front().norm(), 0.1);
  EXPECT_GT(gesture->centre.y(), 0.4);
  EXPECT_GT(gesture->first, 0);
  EXPECT_LT(gesture->last, clip.frame_count() - 1);
}

TEST(ActingHand, IsNoneOfAWalkNorOfWhoStandsNorOfBothHandsAlike) {
  EXPECT_FALSE(acting_hand(walk({}, 30.0, standard_body()).clip));
  Clip standing = knock({}, 30.0, standard_body()).clip;
  standing.poses.resize(5);
  EXPECT_FALSE(acting_hand(standing));
  EXPECT_FALSE(acting_hand(test::clapping(60.0)));
}

/// As of a captured walker whose left arm swings to the horizontal.
TEST(ActingHand, IsNoneOfAWalkWhoseOneArmSwingsFar) {
  Clip clip = repeated(walk({}, 60.0, standard_body()).clip, 4);
  clip.loops = false;
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    Quat& shoulder = clip.poses[f].rotations[LeftShoulder];
    const double raised = 1.0 + 0.8 * std::sin(2.0 * pi * static_cast<double>(f) / 40.0);
    shoulder = exp(Vec3(-raised, 0.0, 0.0)) * shoulder;
  }
  EXPECT_FALSE(acting_hand(clip).has_value());
  for (Pose& pose : clip.poses) pose.root_position.z() = 0.0;
  EXPECT_TRUE(acting_hand(clip).has_value());  // standing, it would be one
}

TEST(HandTip, LiesAHandFromTheWrist) {
  const Skeleton body = standard_body();
  Pose pose;
  pose.rotations.assign(body_joint_count, Quat::Identity());
  EXPECT_NEAR(hand_length(body), 0.189, 1e-3);
  const Vec3 wrist = world_transform(body, pose, LeftWrist).position;
  EXPECT_NEAR((hand_tip(body, pose, true) - wrist - Vec3(hand_length(body), 0, 0)).norm(), 0.0,
              1e-9);
}

}  // namespace
}  // namespace mien::motion
