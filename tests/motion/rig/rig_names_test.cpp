#include "motion/rig/rig_names.h"

#include <gtest/gtest.h>

#include "motion/named_rigs.h"

namespace mien::motion {
namespace {

using namespace mien::test;
using Side = JointWord::Side;

struct Spelling {
  std::string_view name;
  Side side;
  std::string_view word;
};

TEST(RigNames, AreReadInTheSpellingsOfCommonRigs) {
  constexpr Spelling spellings[] = {
      {"LeftUpLeg", Side::left, "upleg"},
      {"mixamorig:RightForeArm", Side::right, "forearm"},
      {"mixamorigLeftToeBase", Side::left, "toebase"},
      {"UpperLeg_L", Side::left, "upperleg"},
      {"LowerArm_R", Side::right, "lowerarm"},
      {"lfemur", Side::left, "femur"},
      {"rhumerus", Side::right, "humerus"},
      {"lhipjoint", Side::left, "hipjoint"},
      {"LHipJoint", Side::left, "hip"},
      {"Bip01 L Thigh", Side::left, "thigh"},
      {"J_Bip_R_UpperLeg", Side::right, "upperleg"},
      {"thigh.L", Side::left, "thigh"},
      {"left_hip", Side::left, "hip"},
      {"r_hand_jnt", Side::right, "hand"},
      {"Spine1", Side::middle, "spine"},
      {"joint_Root", Side::middle, "root"},
      {"root", Side::middle, "root"},
      {"radius", Side::middle, "radius"},
      {"Hips", Side::middle, "hips"},
      {"LThumb", Side::left, "thumb"},
  };
  for (const Spelling& spelling : spellings) {
    const JointWord read = joint_word(spelling.name);
    EXPECT_EQ(read.side, spelling.side) << spelling.name;
    EXPECT_EQ(read.word, spelling.word) << spelling.name;
  }
  EXPECT_EQ(joint_word("").word, "");
  EXPECT_EQ(joint_word("§§42").word, "");
}

TEST(RigNames, TellTheTwoMeaningsOfShoulder) {
  // Clavicle where there is an upper arm besides …
  const Skeleton cmu = rig_of(cmu_like);
  const auto of_cmu = key_joints_by_name(cmu);
  ASSERT_TRUE(of_cmu);
  EXPECT_EQ(cmu.joints[of_cmu->left.upper_arm].name, "LeftArm");
  // … and the upper arm where there is a collar.
  const Skeleton xsens = rig_of(xsens_like);
  const auto of_xsens = key_joints_by_name(xsens);
  ASSERT_TRUE(of_xsens);
  EXPECT_EQ(xsens.joints[of_xsens->left.upper_arm].name, "LeftShoulder");
  EXPECT_EQ(xsens.joints[of_xsens->right.thigh].name, "RightHip");
}

TEST(RigNames, TellTheTwoMeaningsOfFoot) {
  const Skeleton smpl = rig_of(smpl_like);
  const auto keys = key_joints_by_name(smpl);
  ASSERT_TRUE(keys);
  EXPECT_EQ(smpl.joints[keys->left.ankle].name, "left_ankle");
  EXPECT_EQ(smpl.joints[keys->left.toe].name, "left_foot");
  EXPECT_EQ(smpl.joints[keys->left.wrist].name, "left_wrist");
  const Skeleton cmu = rig_of(cmu_like);
  EXPECT_EQ(cmu.joints[key_joints_by_name(cmu)->left.ankle].name, "LeftFoot");
}

TEST(RigNames, GroupTheSpineAsTheRigHasIt) {
  const Skeleton xsens = rig_of(xsens_like);
  const MappedJoints joints = groups_of(xsens, *key_joints_by_name(xsens), 1.0, "name");
  const auto names = [&](BodyJoint joint) {
    std::string all;
    for (int j : joints[joint].group) all += xsens.joints[j].name + " ";
    return all;
  };
  EXPECT_EQ(names(Pelvis), "Hips ");
  EXPECT_EQ(names(Spine), "Chest Chest2 ");
  EXPECT_EQ(names(Chest), "Chest3 Chest4 ");
  EXPECT_EQ(names(Neck), "Neck ");
  EXPECT_EQ(names(LeftClavicle), "LeftCollar ");
  const Skeleton cmu = rig_of(cmu_like);
  const MappedJoints of_cmu = groups_of(cmu, *key_joints_by_name(cmu), 1.0, "name");
  EXPECT_EQ(of_cmu[LeftHip].group.size(), 2u);
  EXPECT_EQ(cmu.joints[of_cmu[LeftHip].position].name, "LeftUpLeg");
  EXPECT_EQ(of_cmu[Spine].group.size(), 2u);
}

TEST(RigNames, NameTheFamily) {
  EXPECT_EQ(rig_family(rig_of(cmu_like)), "cmu-bvh");
  EXPECT_EQ(rig_family(rig_of(xsens_like)), "xsens");
  EXPECT_EQ(rig_family(rig_of(smpl_like)), "smpl");
  EXPECT_EQ(rig_family(standard_body()), "mien");
  Skeleton mixamo = rig_of(cmu_like);
  mixamo.joints[0].name = "mixamorig:Hips";
  EXPECT_EQ(rig_family(mixamo), "mixamo");
}

TEST(RigNames, OfTheCanonicalBodyGiveItself) {
  const Skeleton body = standard_body();
  const auto keys = key_joints_by_name(body);
  ASSERT_TRUE(keys);
  const MappedJoints joints = groups_of(body, *keys, 1.0, "name");
  for (int j = 0; j < body_joint_count; ++j) {
    ASSERT_EQ(joints[j].group.size(), 1u) << j;
    EXPECT_EQ(joints[j].position, j);
  }
}

TEST(RigNames, ThatLackALimbAreRefused) {
  Skeleton rig = rig_of(cmu_like);
  rig.joints[find_joint(rig, "LeftForeArm")].name = "Thing";
  EXPECT_FALSE(key_joints_by_name(rig));
}

TEST(RigNames, ThatTheTreeContradictsAreRefused) {
  Skeleton rig = rig_of(cmu_like);
  std::swap(rig.joints[find_joint(rig, "LeftUpLeg")].name,
            rig.joints[find_joint(rig, "LeftLeg")].name);
  EXPECT_FALSE(key_joints_by_name(rig));
}

}  // namespace
}  // namespace mien::motion
