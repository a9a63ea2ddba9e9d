#include "motion/measures/features/motion_summary.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "motion/handed_rigs.h"
#include "motion/other_rigs.h"
#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(MotionSummary, TellsWhatWasRecognised) {
  const Recording recording =
      test::scaled(on_other_rig(synthetic_clip(long_take()), bones_along_x()), 100.0);
  const MotionSummary summary = summarise(recording);
  EXPECT_EQ(summary.frames, 1400);
  EXPECT_DOUBLE_EQ(summary.duration_seconds, 13.99);
  EXPECT_TRUE(summary.is_human);
  EXPECT_EQ(summary.rig, "mien");
  EXPECT_EQ(summary.joint_names.size(), 21u);
  ASSERT_EQ(summary.joints.size(), 21u);
  EXPECT_EQ(summary.joints[LeftKnee].joint, "LeftKnee");
  EXPECT_EQ(summary.joints[LeftKnee].rig_joints, std::vector<std::string>{"LeftKnee"});
  EXPECT_EQ(summary.joints[LeftKnee].found_by, "name");
  EXPECT_DOUBLE_EQ(summary.unit_m, 0.01);
  EXPECT_EQ(summary.up, "+Y");
  EXPECT_NEAR(summary.height_m, 1.73, 0.01);
  // 12 m in 14 s.
  EXPECT_NEAR(summary.speed_m_s, 12.0 / 14.0, 0.03);
  ASSERT_GE(summary.cycles.size(), 6u);
  ASSERT_GE(summary.steadiest, 0);
  EXPECT_NEAR(summary.cycles[summary.steadiest].keytimes.back(), 1.0, 0.03);
}

TEST(MotionSummary, ListsTheJointsOfBothHands) {
  std::mt19937_64 random(1);
  HandedRig rig = handed_rig(hand_spellings().front());
  const int missing = finger_joint(false, Finger::ring, 2);
  for (int j = rig.joints[size_t(missing)]; j <= rig.joints[size_t(missing)] + 1; ++j)
    rig.skeleton.joints[size_t(j)].name = "Part" + std::to_string(j);
  Recording recording;
  recording.skeleton = rig.skeleton;
  std::vector<double> degrees;
  recording.poses = {handed_pose(rig, random_bends(random, degrees), random)};
  MotionSummary summary = summarise(recording);
  ASSERT_EQ(summary.hands.size(), 2u);
  EXPECT_TRUE(summary.hands[0].is_left);
  EXPECT_TRUE(summary.hands[0].is_recorded);
  EXPECT_EQ(summary.hands[0].joints.size(), 15u);
  EXPECT_TRUE(summary.hands[0].missing.empty());
  EXPECT_EQ(summary.hands[0].joints[3].joint, "LeftIndex1");
  EXPECT_EQ(summary.hands[0].joints[3].rig_joint, "mixamorig:LeftHandIndex1");
  EXPECT_EQ(summary.hands[1].joints.size(), 14u);
  EXPECT_EQ(summary.hands[1].missing, std::vector<std::string>{"RightRing3"});
  recording.poses = {handed_pose(rig, straight_fingers(), random)};
  summary = summarise(recording);
  EXPECT_FALSE(summary.hands[1].is_recorded);
  EXPECT_TRUE(summarise(to_recording(synthetic_clip(steady_walk(1.2, 1.0)))).hands.empty());
}

TEST(MotionSummary, OfWhatIsNoHumanSaysWhy) {
  Recording chain;
  chain.name = "chain";
  Joint joint;
  chain.skeleton.joints = {joint};
  Pose pose;
  pose.rotations = {Quat::Identity()};
  chain.poses = {pose, pose};
  const MotionSummary summary = summarise(chain);
  EXPECT_FALSE(summary.is_human);
  EXPECT_EQ(summary.rig, "unknown");
  EXPECT_EQ(summary.steadiest, -1);
  EXPECT_TRUE(
      std::any_of(summary.warnings.begin(), summary.warnings.end(), [](const std::string& warning) {
        return warning.find("not recognised as a human") != std::string::npos;
      }));
}

TEST(MotionSummary, OfOnePoseHasNoGait) {
  Clip clip = synthetic_clip(steady_walk(1.2, 1.0));
  clip.poses.resize(1);
  const MotionSummary summary = summarise(to_recording(clip));
  EXPECT_TRUE(summary.is_human);
  EXPECT_TRUE(summary.cycles.empty());
  EXPECT_DOUBLE_EQ(summary.speed_m_s, 0.0);
}

}  // namespace
}  // namespace mien::motion
