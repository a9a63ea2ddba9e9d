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

// In files with several people, their names often stand before those of their joints.
TEST(RigNames, MayAllBeginWithTheNameOfThePerson) {
  for (const std::span<const NamedJoint> names :
       {std::span<const NamedJoint>(cmu_like), std::span<const NamedJoint>(xsens_like)}) {
    const Skeleton plain = rig_of(names);
    const auto expected = key_joints_by_name(plain);
    ASSERT_TRUE(expected);
    for (const char* const person : {"Anna_", "Left hand of Ben ", "Character1:"}) {
      Skeleton prefixed = plain;
      for (Joint& joint : prefixed.joints) joint.name = person + joint.name;
      const auto found = key_joints_by_name(prefixed);
      ASSERT_TRUE(found) << person;
      EXPECT_EQ(found->left.wrist, expected->left.wrist) << person;
      EXPECT_EQ(found->right.toe, expected->right.toe) << person;
      EXPECT_EQ(found->left.upper_arm, expected->left.upper_arm) << person;
    }
  }
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
  for (const char* joint : {"LeftArm", "LeftForeArm", "LeftHand", "LThumb"}) {
    rig.joints[find_joint(rig, joint)].name = "Thing";
  }
  EXPECT_FALSE(key_joints_by_name(rig));
}

std::vector<std::vector<int>> groups_by_name(const Skeleton& rig) {
  std::vector<std::vector<int>> groups;
  if (const auto keys = key_joints_by_name(rig)) {
    for (const MappedJoint& joint : groups_of(rig, *keys, 1.0, "name")) {
      groups.push_back(joint.group);
    }
  }
  return groups;
}

TEST(RigNames, AreUnderstoodWhenAnyOneJointIsCalledSomethingElse) {
  for (const Skeleton& rig : {rig_of(cmu_like), rig_of(xsens_like), rig_of(smpl_like),
                              rig_of(biped_like), rig_of(acclaim_like), standard_body()}) {
    const auto expected = groups_by_name(rig);
    ASSERT_FALSE(expected.empty()) << rig.joints[0].name;
    for (size_t j = 0; j < rig.joints.size(); ++j) {
      for (const char* name : {"Thing", "Skull", "HeadTop", "Nose", "Tete", "joint_7", ""}) {
        Skeleton renamed = rig;
        renamed.joints[j].name = name;
        EXPECT_EQ(groups_by_name(renamed), expected) << rig.joints[j].name << " is now " << name;
      }
    }
  }
}

TEST(RigNames, SayWhichJointsTheShapeTold) {
  Skeleton rig = rig_of(cmu_like);
  rig.joints[find_joint(rig, "Head")].name = "Skull";
  const MappedJoints joints = groups_of(rig, *key_joints_by_name(rig), 1.0, "name");
  EXPECT_EQ(joints[Head].found_by, "topology");
  EXPECT_LT(joints[Head].confidence, 1.0);
  EXPECT_EQ(joints[Neck].found_by, "name");
}

/// The rig of which the joints from `name` on are gone.
Skeleton cut_at(const Skeleton& rig, std::string_view name) {
  const int cut = find_joint(rig, name);
  Skeleton shorter;
  std::vector<int> place(rig.joints.size(), -1);
  for (int j = 0; j < rig.size(); ++j) {
    const int parent = rig.joints[j].parent;
    if (j == cut || (parent >= 0 && place[parent] < 0)) continue;
    place[j] = shorter.size();
    shorter.joints.push_back(rig.joints[j]);
    shorter.joints.back().parent = parent < 0 ? -1 : place[parent];
  }
  return shorter;
}

TEST(RigNames, WithoutAHeadHaveTheUpperOfTwoNecksForOne) {
  const Skeleton cmu = cut_at(rig_of(cmu_like), "Head");
  const MappedJoints joints = groups_of(cmu, *key_joints_by_name(cmu), 1.0, "name");
  EXPECT_EQ(cmu.joints[joints[Head].rotation()].name, "Neck1");
  EXPECT_EQ(cmu.joints[joints[Neck].rotation()].name, "Neck");
  // A lone neck turns, and the head goes along.
  const Skeleton xsens = cut_at(rig_of(xsens_like), "Head");
  const MappedJoints lone = groups_of(xsens, *key_joints_by_name(xsens), 1.0, "name");
  EXPECT_EQ(xsens.joints[lone[Neck].rotation()].name, "Neck");
  EXPECT_TRUE(lone[Head].group.empty());
}

TEST(RigNames, LeaveEyesJawAndCrownToTheHead) {
  for (const char* carried : {"LeftEye", "HeadTop_End", "Jaw"}) {
    Skeleton rig = rig_of(cmu_like);
    const int head = find_joint(rig, "Head");
    rig.joints[head].name = "Skull";
    rig.joints.push_back({carried, head, Vec3(0, 0.1, 0), {}});
    rig.joints.push_back({"RightEye", head, Vec3(0, 0.1, 0), {}});
    EXPECT_EQ(key_joints_by_name(rig)->head, head) << carried;
  }
}

TEST(RigNames, LookPastAFootThatIsSteeredByItself) {
  // As robots have it: the foot hangs on the root, the shank ends in a bare end.
  Skeleton rig = rig_of(xsens_like);
  for (const char* side : {"Left", "Right"}) {
    const int ankle = find_joint(rig, std::string(side) + "Ankle");
    rig.joints[ankle].name = std::string(side) + "Knee_end";
    rig.joints.push_back({std::string(side) + "Ankle", 0, Vec3::Zero(), {}});
  }
  const auto keys = key_joints_by_name(rig);
  ASSERT_TRUE(keys);
  EXPECT_EQ(rig.joints[keys->left.ankle].name, "LeftKnee_end");
}

TEST(RigNames, TellOfAnotherFigureBesideTheFirst) {
  const Skeleton one = rig_of(xsens_like);
  EXPECT_EQ(other_figure_in(one, *key_joints_by_name(one)), -1);
  Skeleton two;
  two.joints.push_back({"Scene", -1, Vec3::Zero(), {}});
  for (const char* owner : {"A:", "B:"}) {
    const int first = two.size();
    for (Joint joint : one.joints) {
      joint.name = owner + joint.name;
      joint.parent = joint.parent < 0 ? 0 : joint.parent + first;
      two.joints.push_back(joint);
    }
  }
  const auto keys = key_joints_by_name(two);
  ASSERT_TRUE(keys);
  EXPECT_EQ(two.joints[keys->left.thigh].name, "A:LeftHip");
  ASSERT_GE(other_figure_in(two, *keys), 0);
  EXPECT_EQ(two.joints[other_figure_in(two, *keys)].name, "B:LeftShoulder");
}

TEST(JointWord, TellsWhereAJointBelongs) {
  const auto part = [](std::string_view name) { return body_region_of(joint_word(name)); };
  for (const char* name : {"LowerArm.R", "Palm3.L", "Ring1.L", "LeftHandThumb1", "lclavicle"}) {
    EXPECT_EQ(part(name), BodyRegion::arm) << name;
  }
  for (const char* name : {"LeftUpLeg", "left_hip", "Foot.L", "RightToeBase"}) {
    EXPECT_EQ(part(name), BodyRegion::leg) << name;
  }
  for (const char* name : {"Hips", "Spine1", "Armature", "Tail", "MiddleSpine", ""}) {
    EXPECT_EQ(part(name), BodyRegion::other) << name;
  }
  EXPECT_EQ(part("Neck1"), BodyRegion::head);
}

TEST(RigNames, ThatTheTreeContradictsAreRefused) {
  Skeleton rig = rig_of(cmu_like);
  std::swap(rig.joints[find_joint(rig, "LeftUpLeg")].name,
            rig.joints[find_joint(rig, "LeftLeg")].name);
  EXPECT_FALSE(key_joints_by_name(rig));
}

}  // namespace
}  // namespace mien::motion
