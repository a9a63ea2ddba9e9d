#include "motion/rig/mapped_joint.h"

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

/// 0 ─ 1 ─ 2 ─ 3, and 4 ─ 5 from 1.
Skeleton forked() {
  Skeleton rig;
  for (const int parent : {-1, 0, 1, 2, 1, 4}) {
    Joint joint;
    joint.parent = parent;
    rig.joints.push_back(joint);
  }
  return rig;
}

TEST(PathDown, LeadsFromAncestorToDescendant) {
  EXPECT_EQ(path_down(forked(), 0, 3), (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(path_down(forked(), 1, 5), (std::vector<int>{4, 5}));
  EXPECT_TRUE(path_down(forked(), 2, 5).empty());
  EXPECT_TRUE(path_down(forked(), 3, 3).empty());
}

TEST(CommonAncestor, IsTheLowest) {
  EXPECT_EQ(common_ancestor(forked(), 3, 5), 1);
  EXPECT_EQ(common_ancestor(forked(), 1, 5), 1);
  EXPECT_EQ(common_ancestor(forked(), 2, 2), 2);
}

TEST(Groups, PutAMissingWristOrToeAtTheTip) {
  Skeleton body = standard_body();
  body.joints[LeftAnkle].tip = Vec3(0, -0.06, 0.13);
  body.joints[RightAnkle].tip = Vec3(0, 0, 0);  // no tip at all
  KeyJoints keys;
  keys.pelvis = Pelvis;
  keys.chest = Chest;
  keys.head = Head;
  keys.left = {LeftShoulder, LeftElbow, LeftWrist, LeftHip, LeftKnee, LeftAnkle, -1};
  keys.right = {RightShoulder, RightElbow, RightWrist, RightHip, RightKnee, RightAnkle, -1};
  const MappedJoints joints = groups_of(body, keys, 1.0, "name");
  EXPECT_TRUE(joints[LeftToe].at_tip);
  EXPECT_EQ(joints[LeftToe].position, LeftAnkle);
  EXPECT_EQ(joints[LeftToe].rotation(), -1);
  EXPECT_LT(joints[LeftToe].confidence, 1.0);
  EXPECT_EQ(joints[RightToe].position, -1);
  EXPECT_EQ(joints[RightToe].found_by, "missing");
  EXPECT_DOUBLE_EQ(joints[RightToe].confidence, 0.0);
  EXPECT_EQ(joints[Neck].rotation(), Neck);
}

}  // namespace
}  // namespace mien::motion
