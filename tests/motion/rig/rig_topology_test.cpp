#include "motion/rig/rig_topology.h"

#include <gtest/gtest.h>

#include "motion/other_rigs.h"
#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

using namespace mien::test;

std::optional<TopologyGuess> guess(const Recording& recording) {
  return key_joints_by_topology(recording, world_frames(recording));
}

TEST(Topology, FindsTheCanonicalBodyWithoutNames) {
  const Recording walk = without_names(to_recording(synthetic_clip(steady_walk(1.2, 2.0))));
  const auto found = guess(walk);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->keys.pelvis, Pelvis);
  EXPECT_EQ(found->keys.chest, Chest);
  EXPECT_EQ(found->keys.head, Head);
  EXPECT_EQ(found->keys.left.upper_arm, LeftShoulder);
  EXPECT_EQ(found->keys.left.wrist, LeftWrist);
  EXPECT_EQ(found->keys.right.thigh, RightHip);
  EXPECT_EQ(found->keys.right.ankle, RightAnkle);
  EXPECT_EQ(found->keys.right.toe, RightToe);
  EXPECT_GT(found->confidence, 0.7);
}

TEST(Topology, TellsLeftFromRightByAnatomy) {
  // Both legs and arms listed in the other order: the tree alone cannot tell.
  Clip clip = synthetic_clip(steady_walk(1.2, 2.0));
  Recording walk = to_recording(clip);
  const auto swap_sides = [](auto& values) {
    for (int j = LeftClavicle; j <= LeftWrist; ++j) std::swap(values[j], values[j + 4]);
    for (int j = LeftHip; j <= LeftToe; ++j) std::swap(values[j], values[j + 4]);
  };
  std::vector<Vec3> offsets;
  for (const Joint& joint : walk.skeleton.joints) offsets.push_back(joint.offset);
  swap_sides(offsets);
  for (size_t j = 0; j < offsets.size(); ++j) walk.skeleton.joints[j].offset = offsets[j];
  for (Pose& pose : walk.poses) swap_sides(pose.rotations);
  const auto found = guess(without_names(walk));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->keys.left.thigh, RightHip);
  EXPECT_EQ(found->keys.left.upper_arm, RightShoulder);
}

TEST(Topology, IgnoresARootThatStaysBehind) {
  Recording walk = without_names(to_recording(synthetic_clip(steady_walk(1.2, 2.0))));
  // A new root at the origin; the pelvis moves on it by its own offset.
  Recording behind = walk;
  behind.skeleton.joints.insert(behind.skeleton.joints.begin(), Joint{});
  for (size_t j = 1; j < behind.skeleton.joints.size(); ++j) ++behind.skeleton.joints[j].parent;
  for (size_t t = 0; t < behind.poses.size(); ++t) {
    Pose& pose = behind.poses[t];
    pose.rotations.insert(pose.rotations.begin(), Quat::Identity());
    pose.root_position = Vec3::Zero();
    pose.offsets.assign(1, Vec3::Zero());
    for (const Joint& joint : walk.skeleton.joints) pose.offsets.push_back(joint.offset);
    pose.offsets[1] = walk.poses[t].root_position + Vec3(0, 0, 40);
  }
  const auto found = guess(behind);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->keys.pelvis, Pelvis + 1);
  EXPECT_EQ(found->keys.left.ankle, LeftAnkle + 1);
}

/// Two arms with hands of two fingers on a torso, and nothing else: a fork below two long chains.
Recording two_arms(bool named) {
  Recording recording;
  const auto add = [&](const std::string& name, int parent, const Vec3& offset) {
    recording.skeleton.joints.push_back({named ? name : "", parent, offset, std::nullopt});
    return recording.skeleton.size() - 1;
  };
  const int root = add("Bone", -1, Vec3::Zero());
  const int torso = add("Torso", root, {0, 0.5, 0});
  for (const auto& [side, x] : {std::pair(".L", 1.0), std::pair(".R", -1.0)}) {
    const int shoulder = add(std::string("Shoulder") + side, torso, {0.6 * x, 0.3, 0});
    const int upper = add(std::string("UpperArm") + side, shoulder, {0, 0.1, 0});
    const int lower = add(std::string("LowerArm") + side, upper, {0, -0.6, 0});
    add(std::string("Thumb") + side, lower, {-0.1 * x, -1.2, 0.2});
    for (const auto& [finger, z] : {std::pair("Palm1", 0.1), std::pair("Palm3", -0.1)}) {
      const int palm = add(finger + std::string(side), lower, {0, -1.4, z});
      const int first = add("Index" + std::string(side), palm, {0, -0.4, 0});
      add("Index2" + std::string(side), first, {0, -0.2, 0});
    }
  }
  Pose pose;
  pose.rotations.assign(recording.skeleton.joints.size(), Quat::Identity());
  recording.poses = {pose, pose};
  return recording;
}

TEST(Topology, TakesTwoArmsForNoHuman) {
  EXPECT_FALSE(guess(two_arms(true)));
  EXPECT_FALSE(guess(two_arms(false)));
}

TEST(Topology, HeedsNamesThatSayOtherwise) {
  Recording walk = without_names(to_recording(synthetic_clip(steady_walk(1.2, 2.0))));
  ASSERT_TRUE(guess(walk));
  walk.skeleton.joints[LeftKnee].name = "UpperArm.L";
  EXPECT_FALSE(guess(walk));
  walk.skeleton.joints[LeftKnee].name = "Bone.017";
  EXPECT_TRUE(guess(walk));
}

TEST(Topology, FindsNoHumanInOtherTrees) {
  Recording chain;
  for (int j = 0; j < 12; ++j) {
    Joint joint;
    joint.parent = j - 1;
    joint.offset = Vec3(0, 0.2, 0);
    chain.skeleton.joints.push_back(joint);
  }
  Pose pose;
  pose.rotations.assign(12, Quat::Identity());
  chain.poses = {pose};
  EXPECT_FALSE(guess(chain));
  chain.poses.clear();
  EXPECT_FALSE(guess(chain));
}

TEST(Topology, ComparesNoChainsOfMoreJointsThanARigHas) {
  // A root with so many children, or a spine with a child at each joint, would take minutes.
  for (const bool is_wide : {true, false}) {
    Recording recording;
    recording.skeleton.joints.push_back({"root", -1, Vec3::Zero(), std::nullopt});
    for (int j = 1; j < 60'000; ++j) {
      const int parent = is_wide ? 0 : (j - 1) / 2 * 2;
      recording.skeleton.joints.push_back({"j", parent, Vec3::UnitY(), std::nullopt});
    }
    recording.poses.resize(1);
    recording.poses[0].rotations.assign(60'000, Quat::Identity());
    EXPECT_FALSE(guess(recording));
  }
}

}  // namespace
}  // namespace mien::motion
