#include "motion/rig/calibration.h"

#include <gtest/gtest.h>

#include "motion/other_rigs.h"
#include "motion/rig/rest_calibration.h"
#include "motion/rig/rig_names.h"
#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

using namespace mien::test;

MappedJoints joints_of(const Recording& recording) {
  return groups_of(recording.skeleton, *key_joints_by_name(recording.skeleton), 1.0, "name");
}

Calibration calibration_of(const Recording& recording) {
  const MappedJoints joints = joints_of(recording);
  const RigMotion motion = rig_motion(recording, joints, Quat::Identity());
  return calibrate(std::span(&motion, 1));
}

Clip steady() { return synthetic_clip(steady_walk(1.2, 3.0)); }

TEST(Calibration, TakesATPoseAsItIs) {
  const Calibration calibration = calibration_of(to_recording(steady()));
  EXPECT_TRUE(calibration.from_rest_pose);
  for (const Quat& constant : calibration.to_body) {
    EXPECT_LT(angle_between(constant, Quat::Identity()), 1e-6);
  }
}

TEST(Calibration, TakesAFigureWithSpreadLegsForOneThatStands) {
  // As the CMU skeletons: thighs, shanks and feet 20° outward when all rotations are zero.
  FrameTurns turns;
  turns.fill(Quat::Identity());
  for (const int hip : {LeftHip, RightHip}) {
    const double outward = hip == LeftHip ? -20 * radians_per_degree : 20 * radians_per_degree;
    for (int j = hip; j < hip + 4; ++j) turns[j] = about(Vec3::UnitZ(), outward);
  }
  const Calibration calibration = calibration_of(on_other_rig(steady(), turns));
  EXPECT_TRUE(calibration.from_rest_pose);
  for (int j = 0; j < body_joint_count; ++j) {
    EXPECT_LT(angle_between(calibration.to_body[j], turns[j].conjugate()), 1e-6)
        << name_of(BodyJoint(j));
  }
}

TEST(Calibration, MeasuresWhatTheZeroPoseHasWrong) {
  // Upper arm and forearm twisted by 50° about their bone in an otherwise proper T-pose.
  FrameTurns turns;
  turns.fill(Quat::Identity());
  for (const int j : {LeftShoulder, LeftElbow})
    turns[j] = about(Vec3::UnitX(), 50 * radians_per_degree);
  const Recording recording = on_other_rig(steady(), turns);
  const Calibration calibration = calibration_of(recording);
  EXPECT_TRUE(calibration.from_rest_pose);
  for (const int j : {LeftShoulder, LeftElbow, RightShoulder, RightElbow}) {
    EXPECT_LT(angle_between(calibration.to_body[j], turns[j].conjugate()), 1.0 * radians_per_degree)
        << name_of(BodyJoint(j));
  }
}

TEST(Calibration, StraightensHandsThatHangWhenAllRotationsAreZero) {
  // As the skeletons of some studios: level arms, but fingers that point down.
  FrameTurns turns;
  turns.fill(Quat::Identity());
  turns[LeftWrist] = about(Vec3::UnitZ(), -90 * radians_per_degree);
  turns[RightWrist] = about(Vec3::UnitZ(), 90 * radians_per_degree);
  const Calibration calibration = calibration_of(on_other_rig(steady(), turns));
  EXPECT_TRUE(calibration.from_rest_pose);
  for (const BodyJoint j : {LeftWrist, RightWrist}) {
    EXPECT_LT(angle_between(calibration.to_body[j], turns[j].conjugate()), 2.0 * radians_per_degree)
        << name_of(j);
    EXPECT_GT(calibration.body.joints[j].tip->normalized().dot(rest_direction(j)), 0.99);
  }
}

TEST(Calibration, DoesNotTakeEyesAndJawForTheCrown) {
  Recording without = to_recording(steady());
  without.skeleton.joints[Head].tip.reset();
  Recording with_face = without;
  const std::pair<const char*, Vec3> parts[] = {{"LeftEye", {0.03, 0.10, 0.09}},
                                                {"RightEye", {-0.03, 0.10, 0.09}},
                                                {"jaw", {0.0, -0.02, 0.05}},
                                                {"jaw_end", {0.0, -0.01, 0.03}}};
  for (const auto& [name, offset] : parts)
    with_face.skeleton.joints.push_back({name, Head, offset, std::nullopt});
  for (Pose& pose : with_face.poses)
    pose.rotations.resize(with_face.skeleton.joints.size(), Quat::Identity());
  const Calibration plain = calibration_of(without);
  const Calibration faced = calibration_of(with_face);
  EXPECT_LT(angle_between(plain.to_body[Head], faced.to_body[Head]), 1e-9);
  EXPECT_LT((*plain.body.joints[Head].tip - *faced.body.joints[Head].tip).norm(), 1e-9);
}

TEST(Calibration, DoesNotTakeALineOfBonesForAFigure) {
  const Recording recording = on_other_rig(steady(), bones_along_x());
  const MappedJoints joints = joints_of(recording);
  const RigMotion motion = rig_motion(recording, joints, Quat::Identity());
  EXPECT_FALSE(rest_calibration(motion));
  const Calibration calibration = calibrate(std::span(&motion, 1));
  EXPECT_FALSE(calibration.from_rest_pose);
  const FrameTurns turns = bones_along_x();
  for (int j = 0; j < body_joint_count; ++j) {
    EXPECT_LT(angle_between(calibration.to_body[j], turns[j].conjugate()), 1.0 * radians_per_degree)
        << name_of(BodyJoint(j));
  }
}

TEST(Calibration, GivesTheBodyItsProportions) {
  Clip clip = steady();
  clip.body.joints[LeftElbow].offset *= 1.07;
  clip.body.joints[RightKnee].offset *= 0.96;
  const Calibration calibration = calibration_of(on_other_rig(clip, random_turns(8)));
  for (int j = Spine; j < body_joint_count; ++j) {
    EXPECT_NEAR(calibration.body.joints[j].offset.norm(), clip.body.joints[j].offset.norm(), 1e-9)
        << name_of(BodyJoint(j));
  }
  EXPECT_TRUE(is_body(calibration.body));
}

}  // namespace
}  // namespace mien::motion
