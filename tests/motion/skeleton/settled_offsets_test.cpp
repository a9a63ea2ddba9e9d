#include "motion/skeleton/settled_offsets.h"

#include <gtest/gtest.h>

namespace mien::motion {

namespace {

Pose with_offsets(const std::vector<Vec3>& offsets) {
  Pose pose;
  pose.rotations.assign(3, Quat::Identity());
  pose.offsets = offsets;
  return pose;
}

const std::vector<Vec3> rigid{{0, 1, 0}, {0.5, 0, 0}, {0, 0.25, 0}};

Recording chain_of(std::vector<Pose> poses) {
  Recording recording;
  for (int j = 0; j < 3; ++j) recording.skeleton.joints.push_back({"j", j - 1, Vec3::Ones(), {}});
  recording.poses = std::move(poses);
  return recording;
}

}  // namespace

TEST(SettledOffsets, OfRigidLimbsAreTheSkeletons) {
  std::vector<Vec3> rounded = rigid;
  rounded[1].x() += 1e-9;
  Recording recording = chain_of({with_offsets(rigid), with_offsets(rounded), with_offsets({})});
  settle_offsets(recording);
  for (const Pose& pose : recording.poses) EXPECT_TRUE(pose.offsets.empty());
  EXPECT_EQ(recording.skeleton.joints[1].offset, rigid[1]);
  EXPECT_EQ(recording.skeleton.joints[2].offset, rigid[2]);
}

TEST(SettledOffsets, OfALimbThatGrowsStayAndOthersAreTheFirst) {
  std::vector<Vec3> grown = rigid;
  grown[2].y() += 0.01;
  Recording recording = chain_of({with_offsets(rigid), with_offsets({}), with_offsets(grown)});
  settle_offsets(recording);
  for (const Pose& pose : recording.poses) {
    ASSERT_EQ(pose.offsets.size(), 3u);
    EXPECT_EQ(pose.offsets[1], rigid[1]);
  }
  EXPECT_EQ(recording.poses[1].offsets[2], rigid[2]);
  EXPECT_EQ(recording.poses[2].offsets[2], grown[2]);
  EXPECT_EQ(recording.skeleton.joints[2].offset, Vec3::Ones());
}

TEST(SettledOffsets, AreThoseOfTheFirstPoseWhateverTheRootDoes) {
  std::vector<Vec3> moved = rigid;
  moved[0] = {5, 6, 7};
  EXPECT_TRUE(has_offsets_of(with_offsets(rigid), with_offsets(moved)));
  moved[1].x() += 1e-9;
  EXPECT_TRUE(has_offsets_of(with_offsets(rigid), with_offsets(moved)));
  moved[1].x() += 1e-6;
  EXPECT_FALSE(has_offsets_of(with_offsets(rigid), with_offsets(moved)));
}

}  // namespace mien::motion
