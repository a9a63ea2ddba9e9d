#include <gtest/gtest.h>

#include "motion/lint/lint.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/finger_angles.h"

#include "injected_faults.h"

namespace mien::motion {
namespace {

using namespace mien::test;

Clip walk_with(const std::vector<Quat>& fingers) {
  Clip clip = three_cycles(builtin_walks().front());
  for (Pose& pose : clip.poses) pose.fingers = fingers;
  return clip;
}

std::vector<Finding> of_fingers(std::vector<Finding> findings) {
  std::erase_if(findings, [](const Finding& each) { return each.check != "finger-limit"; });
  return findings;
}

TEST(FingerLimits, AreKeptByHandsAtEaseStraightHandsAndFists) {
  EXPECT_TRUE(of_fingers(lint(walk_with(relaxed_fingers()))).empty());
  std::vector<Quat> fingers(finger_joint_count, Quat::Identity());
  EXPECT_TRUE(of_fingers(lint(walk_with(fingers))).empty());
  for (int j = 0; j < finger_joint_count; ++j) {
    const double degrees = finger_of(j) == Finger::thumb ? 40.0 : segment_of(j) == 2 ? 70.0 : 90.0;
    fingers[size_t(j)] = exp(degrees * radians_per_degree * flexion_axis(j));
  }
  EXPECT_TRUE(of_fingers(lint(walk_with(fingers))).empty());
}

TEST(FingerLimits, FindEveryJointThatIsBentBackwardsInItsFrames) {
  for (int j = 0; j < finger_joint_count; ++j) {
    Clip clip = walk_with(relaxed_fingers());
    const double least = finger_ranges(j).flexion.least;
    for (int f = 10; f <= 14; ++f)
      clip.poses[size_t(f)].fingers[size_t(j)] =
          exp((least - 20.0) * radians_per_degree * flexion_axis(j));
    const std::vector<Finding> found = of_fingers(lint(clip));
    ASSERT_EQ(found.size(), 1u) << finger_joint_name(j);
    EXPECT_EQ(found[0].joint, finger_joint_name(j));
    EXPECT_EQ(found[0].first, 10);
    EXPECT_EQ(found[0].last, 14);
    EXPECT_EQ(found[0].severity, Severity::warning);
    EXPECT_NEAR(found[0].measured, 20.0, 1e-6);
    EXPECT_NE(found[0].sentence.find("bent backwards"), std::string::npos) << found[0].sentence;
  }
}

TEST(FingerLimits, FindFingersThatAreSpreadTooFar) {
  Clip clip = walk_with(relaxed_fingers());
  const int joint = finger_joint(false, Finger::index, 0);
  for (Pose& pose : clip.poses)
    pose.fingers[size_t(joint)] = exp(Vec3(0, 45 * radians_per_degree, 0));
  const std::vector<Finding> found = of_fingers(lint(clip));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].sentence,
            "The right index finger is bent sideways at its first joint: 20° beyond its range.");
}

TEST(FingerLimits, AreWidenedToWhatTheOriginalDid) {
  Clip clip = walk_with(relaxed_fingers());
  const int joint = finger_joint(true, Finger::ring, 1);
  for (Pose& pose : clip.poses)
    pose.fingers[size_t(joint)] = exp(-35 * radians_per_degree * flexion_axis(joint));
  EXPECT_EQ(of_fingers(lint(clip)).size(), 1u);
  EXPECT_TRUE(of_fingers(lint(clip, {}, &clip)).empty());
  Clip bare = clip;
  for (Pose& pose : bare.poses) pose.fingers.clear();
  EXPECT_EQ(of_fingers(lint(clip, {}, &bare)).size(), 1u);
  EXPECT_TRUE(of_fingers(lint(bare, {}, &clip)).empty());
}

}  // namespace
}  // namespace mien::motion
