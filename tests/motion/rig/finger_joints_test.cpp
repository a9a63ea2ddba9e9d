#include "motion/rig/finger_joints.h"

#include <gtest/gtest.h>

#include "motion/handed_rigs.h"
#include "motion/named_rigs.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(FingerNames, AreReadInTheSpellingsOfAllFamilies) {
  for (const HandSpelling& spelling : hand_spellings()) {
    for (const bool left : {true, false}) {
      for (int f = 0; f < fingers_per_hand; ++f) {
        for (int segment = -1; segment < joints_per_finger; ++segment) {
          const std::string name = spelling.name(left, Finger(f), segment);
          if (name.empty()) continue;
          const FingerName read = read_finger_name(name);
          EXPECT_TRUE(read.is_known) << name;
          const int first = spelling.family == "Rokoko" ? 1 : 0;
          EXPECT_EQ(read.number < 0 ? static_cast<int>(read.finger) : read.number - first, f)
              << name;
        }
      }
    }
  }
}

TEST(FingerNames, AreNotReadFromOtherNames) {
  for (const char* name :
       {"LeftHand", "lfingers", "LeftFingerBase", "LeftHandProp", "hand_ik_l", "Bip01 L Hand",
        "LeftCarpus", "weapon_01", "Finger9", "FirstAid", "LeftHandSecond"})
    EXPECT_FALSE(read_finger_name(name).is_known) << name;
}

TEST(FingerJoints, AreNoHandInRigsOfThumbAndOneFinger) {
  const Skeleton rig = rig_of(cmu_like);
  const FingerJoints found =
      finger_joints(rig, find_joint(rig, "LeftHand"), find_joint(rig, "RightHand"));
  EXPECT_FALSE(found.is_hand[0]);
  EXPECT_FALSE(found.is_hand[1]);
  for (const int joint : found.joints) EXPECT_EQ(joint, -1);
}

TEST(FingerJoints, AreNotLookedForWithoutWrists) {
  const HandedRig rig = handed_rig(hand_spellings().front());
  const FingerJoints found = finger_joints(rig.skeleton, -1, RightWrist);
  EXPECT_FALSE(found.is_hand[0]);
  EXPECT_TRUE(found.is_hand[1]);
}

TEST(FingerJoints, OfBipedWithoutThumbsBeginAtTheIndexFinger) {
  const HandSpelling biped = {"", [](bool left, Finger finger, int segment) {
                                for (const HandSpelling& each : hand_spellings()) {
                                  const std::string name = each.name(left, finger, segment);
                                  if (each.family != "Biped" || segment < 0) continue;
                                  return finger == Finger::thumb ? "Stub" : name;
                                }
                                return std::string();
                              }};
  const HandedRig rig = handed_rig(biped);
  const FingerJoints found = finger_joints(rig.skeleton, LeftWrist, RightWrist);
  EXPECT_TRUE(found.is_hand[0] && found.is_hand[1]);
  for (int joint = 0; joint < finger_joint_count; ++joint)
    EXPECT_EQ(found.joints[size_t(joint)],
              finger_of(joint) == Finger::thumb ? -1 : rig.joints[size_t(joint)])
        << finger_joint_name(joint);
}

TEST(FingerJoints, TakeTheLongestChainWhereAFingerIsNamedTwice) {
  HandedRig rig = handed_rig(hand_spellings().front());
  add_joint(rig.skeleton, "mixamorig:LeftHandIndexTarget", LeftWrist, Vec3(0.1, 0, 0));
  const FingerJoints found = finger_joints(rig.skeleton, LeftWrist, RightWrist);
  EXPECT_EQ(found.joints[size_t(finger_joint(true, Finger::index, 0))],
            rig.joints[size_t(finger_joint(true, Finger::index, 0))]);
}

}  // namespace
}  // namespace mien::motion
