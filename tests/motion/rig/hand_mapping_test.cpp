#include "motion/rig/hand_mapping.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "motion/handed_rigs.h"
#include "motion/rig/body_mapping.h"
#include "motion/skeleton/finger_angles.h"
#include "motion/skeleton/recorded_hands.h"

namespace mien::motion {
namespace {

using namespace mien::test;

constexpr double most_error_degrees = 0.1;

std::array<Quat, 2> random_twists(std::mt19937_64& random) {
  std::uniform_real_distribution<double> angle(-pi, pi);
  return {exp(Vec3(angle(random), 0, 0)), exp(Vec3(angle(random), 0, 0))};
}

Recording recording_of(const HandedRig& rig, const std::vector<std::vector<Quat>>& fingers,
                       std::mt19937_64& random) {
  Recording recording;
  recording.name = "hands";
  recording.format = "bvh";
  recording.skeleton = rig.skeleton;
  for (const std::vector<Quat>& each : fingers)
    recording.poses.push_back(handed_pose(rig, each, random));
  return recording;
}

/// The largest error of flexion over all joints of a pose, and what is left over of the rotations.
void expect_bends(const Pose& pose, const std::vector<double>& degrees, const std::string& where) {
  ASSERT_EQ(pose.fingers.size(), size_t(finger_joint_count)) << where;
  for (int joint = 0; joint < finger_joint_count; ++joint) {
    const FingerAngles angles = finger_angles(pose, joint);
    const std::string name = where + ", " + finger_joint_name(joint);
    EXPECT_NEAR(angles.flexion, degrees[size_t(joint)], most_error_degrees) << name;
    EXPECT_NEAR(angles.abduction, 0.0, most_error_degrees) << name;
    const Quat bend(
        Eigen::AngleAxisd(degrees[size_t(joint)] * radians_per_degree, flexion_axis(joint)));
    EXPECT_LT(angle_between(pose.fingers[size_t(joint)], bend) / radians_per_degree,
              most_error_degrees)
        << name;
  }
}

TEST(HandMapping, TakesStraightFingersThatNeverMoveForNotRecorded) {
  std::mt19937_64 random(11);
  const HandedRig rig = handed_rig(hand_spellings().front(), random_twists(random));
  std::vector<std::vector<Quat>> fingers(4, straight_fingers());
  const auto has_any = [&](const Recording& recording) {
    return has_fingers(to_body(in_random_frames(recording, random)));
  };
  EXPECT_FALSE(has_any(recording_of(rig, fingers, random)));
  fingers[2][4] = Quat(Eigen::AngleAxisd(radians_per_degree, flexion_axis(4)));
  EXPECT_TRUE(has_any(recording_of(rig, fingers, random)));  // one moves
  std::vector<double> degrees;
  fingers.assign(4, random_bends(random, degrees));
  EXPECT_TRUE(has_any(recording_of(rig, fingers, random)));  // a fist that stays one
}

TEST(HandMapping, RecoversBendsInTheSpellingsOfAllFamiliesWhereverThePalmPointsAtRest) {
  std::mt19937_64 random(7);
  for (const HandSpelling& spelling : hand_spellings()) {
    for (int round = 0; round < 3; ++round) {
      const HandedRig rig = handed_rig(spelling, random_twists(random));
      std::vector<double> first, second;
      const auto bends = random_bends(random, first);
      const auto more = random_bends(random, second);
      const Recording recording = recording_of(rig, {bends, more}, random);
      const BodyMapping mapping = recognise(recording);
      EXPECT_TRUE(missing_finger_joints(mapping.hands).empty()) << spelling.family;
      for (int joint = 0; joint < finger_joint_count; ++joint)
        EXPECT_EQ(mapping.hands.joints[size_t(joint)], rig.joints[size_t(joint)])
            << spelling.family << " " << finger_joint_name(joint);
      const Clip clip = to_body(recording, mapping);
      expect_bends(clip.poses[0], first, spelling.family);
      expect_bends(clip.poses[1], second, spelling.family);
    }
  }
}

TEST(HandMapping, RecoversBendsInAnyJointFramesFromTheFrameOfStraightFingers) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> angle(-0.5, 0.5);
  for (const HandSpelling& spelling : hand_spellings()) {
    const HandedRig rig = handed_rig(spelling, random_twists(random));
    std::vector<double> degrees;
    const auto bends = random_bends(random, degrees);
    // Bent, spread and turned about themselves: no frame to calibrate from.
    std::vector<Quat> crooked = bends;
    for (Quat& finger : crooked)
      finger = finger * exp(Vec3(angle(random), angle(random), angle(random)));
    const Recording recording =
        in_random_frames(recording_of(rig, {crooked, bends, straight_fingers()}, random), random);
    const Clip clip = to_body(recording);
    expect_bends(clip.poses[1], degrees, spelling.family);
    expect_bends(clip.poses[2], std::vector<double>(finger_joint_count, 0.0), spelling.family);
    for (size_t j = 0; j < size_t(finger_joint_count); ++j)
      EXPECT_LT(angle_between(clip.poses[0].fingers[j], crooked[j]), 1e-6) << spelling.family;
  }
}

TEST(HandMapping, CountsBendsOfTheZeroPoseAsBends) {
  std::mt19937_64 random(9);
  std::vector<double> degrees;
  const auto bends = random_bends(random, degrees);
  HandedRig rig = handed_rig(hand_spellings().front());
  Recording recording = recording_of(rig, {bends}, random);
  // The same figure, whose fingers are bent already when all rotations are zero.
  const JointTransforms bent = world_transforms(
      rig.skeleton, {Vec3::Zero(), recording_of(rig, {bends}, random).poses[0].rotations});
  HandedRig fist = rig;
  Pose arms = recording.poses.front();
  for (const int joint : rig.joints) arms.rotations[size_t(joint)] = Quat::Identity();
  for (int joint = 0; joint < finger_joint_count; ++joint) {
    const auto at = size_t(rig.joints[size_t(joint)]);
    const BodyJoint wrist = is_left_finger(joint) ? LeftWrist : RightWrist;
    const int parent = rig.skeleton.joints[at].parent;
    fist.skeleton.joints[at].offset =
        bent.rotations[wrist].conjugate() * (bent.positions[at] - bent.positions[size_t(parent)]);
    if (segment_of(joint) + 1 < joints_per_finger) continue;
    const auto end = at + 1;
    fist.skeleton.joints[end].offset =
        bent.rotations[wrist].conjugate() * (bent.positions[end] - bent.positions[at]);
  }
  const Quat nudge = exp(Vec3(0, 0, 1e-4));  // or nothing would have been recorded
  arms.rotations[size_t(rig.joints[0])] = nudge;
  recording.skeleton = fist.skeleton;
  recording.poses = {arms};
  expect_bends(to_body(recording).poses[0], degrees, "fist");
}

TEST(HandMapping, AddsTheRotationOfAMetacarpalToTheFirstJoint) {
  std::mt19937_64 random(10);
  for (const HandSpelling& spelling : hand_spellings()) {
    const HandedRig rig = handed_rig(spelling);
    const int joint = finger_joint(false, Finger::little, 0);
    if (rig.metacarpals[size_t(joint)] < 0) continue;
    std::vector<double> degrees;
    const auto bends = random_bends(random, degrees);
    Recording recording = recording_of(rig, {bends}, random);
    recording.poses[0].rotations[size_t(rig.metacarpals[size_t(joint)])] =
        Quat(Eigen::AngleAxisd(10 * radians_per_degree, flexion_axis(joint)));
    degrees[size_t(joint)] += 10.0;
    expect_bends(to_body(recording).poses[0], degrees, spelling.family);
  }
}

TEST(HandMapping, LeavesTheOtherJointsAsTheyAreWithoutFingers) {
  std::mt19937_64 random(11);
  const HandedRig rig = handed_rig(hand_spellings().front(), random_twists(random));
  std::vector<double> degrees;
  const Recording handed = recording_of(rig, {random_bends(random, degrees)}, random);
  Recording bare = handed;
  for (size_t j = 0; j < bare.skeleton.joints.size(); ++j) {
    if (j >= size_t(body_joint_count)) bare.skeleton.joints[j].name = "part" + std::to_string(j);
  }
  const Clip with = to_body(handed);
  const Clip without = to_body(bare);
  EXPECT_TRUE(has_fingers(with));
  EXPECT_FALSE(has_fingers(without));
  for (int j = 0; j < body_joint_count; ++j) {
    EXPECT_EQ(with.poses[0].rotations[size_t(j)].coeffs(),
              without.poses[0].rotations[size_t(j)].coeffs());
    EXPECT_EQ(with.body.joints[size_t(j)].offset, without.body.joints[size_t(j)].offset);
  }
}

TEST(HandMapping, TakesFingersThatNeverLeaveTheZeroPoseAsNotRecorded) {
  std::mt19937_64 random(12);
  const HandedRig rig = handed_rig(hand_spellings().front());
  Recording recording =
      recording_of(rig, {straight_fingers(), straight_fingers(), straight_fingers()}, random);
  EXPECT_TRUE(recognise(recording).hands.any());
  EXPECT_FALSE(has_fingers(to_body(recording)));
  EXPECT_EQ(to_recording(to_body(recording)).skeleton.size(), body_joint_count);
  recording.poses[2].rotations[size_t(rig.joints[17])] = exp(Vec3(0.01, 0, 0));
  const Clip clip = to_body(recording);
  for (const Pose& pose : clip.poses) EXPECT_EQ(pose.fingers.size(), size_t(finger_joint_count));
}

TEST(HandMapping, KeepsMissingFingersStraightAndSaysWhichTheyAre) {
  std::mt19937_64 random(13);
  const HandSpelling mixamo = hand_spellings().front();
  const HandSpelling three = {
      "three fingers", [&](bool left, Finger finger, int segment) {
        const std::string name = mixamo.name(left, finger, segment);
        return finger > Finger::middle && !name.empty() ? "Extra" + name.substr(10, 4) : name;
      }};
  const HandedRig rig = handed_rig(three);
  std::vector<double> degrees;
  const Recording recording = recording_of(rig, {random_bends(random, degrees)}, random);
  const BodyMapping mapping = recognise(recording);
  ASSERT_TRUE(mapping.hands.has(true) && mapping.hands.has(false));
  const std::vector<std::string> missing = missing_finger_joints(mapping.hands);
  EXPECT_EQ(missing.size(), 12u);
  EXPECT_EQ(missing.front(), "LeftRing1");
  EXPECT_NE(std::find(missing.begin(), missing.end(), "RightLittle3"), missing.end());
  ASSERT_FALSE(mapping.warnings.empty());
  EXPECT_NE(mapping.warnings.back().find("LeftRing1"), std::string::npos)
      << mapping.warnings.back();
  for (int joint = 0; joint < finger_joint_count; ++joint)
    if (finger_of(joint) > Finger::middle) degrees[size_t(joint)] = 0.0;
  // With three knuckles the palm is known less well, but these fingers bend about its own axes.
  expect_bends(to_body(recording, mapping).poses[0], degrees, "three fingers");
}

TEST(HandMapping, ShowsAHandThatTheRigLacksAtEase) {
  std::mt19937_64 random(14);
  HandedRig rig = handed_rig(hand_spellings().front());
  for (Joint& joint : rig.skeleton.joints)
    if (joint.name.starts_with("mixamorig:Right")) joint.name = "Part" + joint.name.substr(15, 3);
  std::vector<double> degrees;
  const Recording recording = recording_of(rig, {random_bends(random, degrees)}, random);
  const BodyMapping mapping = recognise(recording);
  EXPECT_TRUE(mapping.hands.has(true));
  EXPECT_FALSE(mapping.hands.has(false));
  EXPECT_NE(mapping.warnings.back().find("right hand"), std::string::npos);
  const Pose pose = to_body(recording, mapping).poses[0];
  for (int joint = joints_per_hand; joint < finger_joint_count; ++joint)
    EXPECT_EQ(pose.fingers[size_t(joint)].coeffs(), relaxed_fingers()[size_t(joint)].coeffs());
}

TEST(HandMapping, LeavesOutAHandWhoseKnucklesAreInOnePlace) {
  std::mt19937_64 random(15);
  HandedRig rig = handed_rig(hand_spellings().front());
  for (int joint = 0; joint < joints_per_hand; joint += joints_per_finger)
    rig.skeleton.joints[size_t(rig.joints[size_t(joint)])].offset = Vec3(0.09, 0, 0);
  std::vector<double> degrees;
  const BodyMapping mapping = recognise(recording_of(rig, {random_bends(random, degrees)}, random));
  EXPECT_FALSE(mapping.hands.has(true));
  EXPECT_TRUE(mapping.hands.has(false));
}

TEST(HandMapping, GivesContinuousQuaternions) {
  std::mt19937_64 random(16);
  const HandedRig rig = handed_rig(hand_spellings().front());
  std::vector<std::vector<Quat>> fingers;
  for (int f = 0; f < 40; ++f) {
    fingers.push_back(straight_fingers());
    for (Quat& finger : fingers.back()) finger = exp(Vec3(0, 0, 0.3 * f));
  }
  Recording recording = recording_of(rig, fingers, random);
  for (size_t f = 0; f < recording.poses.size(); f += 2)
    for (Quat& rotation : recording.poses[f].rotations) rotation.coeffs() *= -1.0;
  const Clip clip = to_body(recording);
  for (size_t f = 1; f < clip.poses.size(); ++f)
    for (size_t j = 0; j < size_t(finger_joint_count); ++j)
      EXPECT_GT(clip.poses[f].fingers[j].dot(clip.poses[f - 1].fingers[j]), 0.0) << f;
}

}  // namespace
}  // namespace mien::motion
