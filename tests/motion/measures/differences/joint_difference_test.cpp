#include "motion/measures/differences/joint_difference.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/changed_motion.h"

namespace mien::motion {
namespace {

using namespace mien::test;

std::vector<JointDifference> differences(const Clip& before, const Clip& now) {
  return joint_differences(paired(before, now), before.body, now.body);
}

double chord(double radius, double radians) { return 2.0 * radius * std::sin(0.5 * radians); }

TEST(BoneAxes, StandAtRightAnglesOnTheBone) {
  const Skeleton body = standard_body();
  const std::vector<BoneAxes> axes = bone_axes(body);
  for (int j = 0; j < body_joint_count; ++j) {
    EXPECT_NEAR(axes[j].along.dot(axes[j].side), 0.0, 1e-12);
    EXPECT_NEAR(axes[j].along.dot(axes[j].up), 0.0, 1e-12);
    EXPECT_NEAR(axes[j].side.dot(axes[j].up), 0.0, 1e-12);
    EXPECT_NEAR(axes[j].side.norm(), 1.0, 1e-12);
  }
  EXPECT_TRUE(axes[LeftElbow].along.isApprox(body.joints[LeftWrist].offset.normalized(), 1e-12));
  EXPECT_TRUE(axes[Pelvis].along.isApprox(body.joints[Spine].offset.normalized(), 1e-12));
}

TEST(JointDifference, OfAMotionToItselfIsExactlyZero) {
  const Clip walk = changeable_walk();
  for (const JointDifference& joint : differences(walk, walk)) {
    for (const auto* curve :
         {&joint.position_m, &joint.point_m, &joint.aligned_m, &joint.velocity_m_s,
          &joint.turn_radians, &joint.twist_radians, &joint.offset_m}) {
      ASSERT_EQ(curve->size(), walk.poses.size());
      EXPECT_EQ(peak_of(*curve).value, 0.0) << joint.name;
    }
  }
}

TEST(JointDifference, IsZeroForRotationsWrittenWithTheOtherSign) {
  const Clip walk = changeable_walk();
  Clip now = walk;
  for (Pose& pose : now.poses) pose.rotations[Chest].coeffs() *= -1.0;
  for (const JointDifference& joint : differences(walk, now)) {
    EXPECT_EQ(peak_of(joint.point_m).value, 0.0) << joint.name;
    EXPECT_EQ(peak_of(joint.turn_radians).value, 0.0) << joint.name;
  }
}

TEST(JointDifference, OfATwistedBoneIsTheChordOfItsVirtualPoints) {
  const Clip walk = changeable_walk();
  const Vec3 along = bone_axes(walk.body)[LeftElbow].along;
  for (const double angle : {0.1 * degree, 1.0 * degree, 30.0 * degree}) {
    const auto joints = differences(walk, with_turn(walk, LeftElbow, along, angle));
    EXPECT_LT(peak_of(joints[LeftElbow].position_m).value, 1e-12);
    EXPECT_LT(peak_of(joints[LeftWrist].position_m).value, 1e-12);  // it lies on the axis
    for (const int joint : {LeftElbow, LeftWrist}) {
      const double largest = peak_of(joints[joint].point_m).value;
      EXPECT_LE(largest, chord(virtual_point_m, angle) + 1e-12);
      EXPECT_GT(largest, 0.7 * chord(virtual_point_m, angle));
    }
    for (size_t t = 0; t < walk.poses.size(); ++t) {
      EXPECT_NEAR(joints[LeftElbow].point_m[t], chord(virtual_point_m, angle), 1e-12);
      EXPECT_NEAR(joints[LeftElbow].twist_radians[t], angle, 1e-12);
    }
  }
}

TEST(JointDifference, OfABentJointMovesWhatItCarriesByTheChord) {
  const Clip walk = changeable_walk();
  const BoneAxes axes = bone_axes(walk.body)[LeftElbow];
  const auto joints = differences(walk, with_turn(walk, LeftElbow, axes.side, degree));
  const double forearm = walk.body.joints[LeftWrist].offset.norm();
  for (size_t t = 0; t < walk.poses.size(); ++t) {
    EXPECT_NEAR(joints[LeftWrist].position_m[t], chord(forearm, degree), 1e-12);
    EXPECT_NEAR(joints[LeftElbow].turn_radians[t], degree, 1e-12);
    EXPECT_NEAR(joints[LeftElbow].twist_radians[t], 0.0, 1e-12);
  }
}

TEST(JointDifference, IsThatOfTheJointThatTurnsAndNotOfThoseThatFollow) {
  const Clip walk = changeable_walk();
  for (int turned = 0; turned < body_joint_count; ++turned) {
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.3, -0.5, 0.8)}) {
      const auto joints = differences(walk, with_turn(walk, BodyJoint(turned), axis, degree));
      for (int j = 0; j < body_joint_count; ++j)
        EXPECT_EQ(joints[j].differs_itself(), j == turned) << joints[j].name << " for " << turned;
    }
  }
}

TEST(JointDifference, IsTheSameWithTheMotionsExchanged) {
  const Clip walk = changeable_walk();
  const Clip now = with_turn(walk, Chest, Vec3(0.2, 1, 0.4), 3.0 * degree);
  const auto there = differences(walk, now);
  const auto back = differences(now, walk);
  for (size_t j = 0; j < there.size(); ++j) {
    EXPECT_EQ(there[j].position_m, back[j].position_m);
    EXPECT_EQ(there[j].point_m, back[j].point_m);
    EXPECT_EQ(there[j].velocity_m_s, back[j].velocity_m_s);
    for (size_t t = 0; t < walk.poses.size(); ++t)
      EXPECT_NEAR(there[j].turn_radians[t], back[j].turn_radians[t], 1e-12);
  }
}

TEST(JointDifference, VelocityIsThatOfTheDisplacement) {
  const Clip walk = changeable_walk();
  Clip now = walk;
  for (int t = 0; t < now.frame_count(); ++t)
    now.poses[t].root_position.x() += 0.3 * t / now.frames_per_second;
  for (const JointDifference& joint : differences(walk, now)) {
    for (const double speed : joint.velocity_m_s) EXPECT_NEAR(speed, 0.3, 1e-9);
  }
}

TEST(JointDifference, IsGoneAfterAlignmentForPosesTurnedScaledAndMoved) {
  const Clip walk = changeable_walk();
  Clip now = set_elsewhere(walk, Vec3(1.0, 0.2, -2.0), 1.1);
  for (Joint& joint : now.body.joints) joint.offset *= 1.25;
  for (const JointDifference& joint : differences(walk, now)) {
    EXPECT_GT(peak_of(joint.position_m).value, 0.5);
    EXPECT_LT(peak_of(joint.aligned_m).value, 1e-12);
  }
}

TEST(JointDifference, TellsABoneThatGrew) {
  const Clip walk = changeable_walk();
  Clip now = walk;
  now.body.joints[RightKnee].offset *= 1.01;
  const auto joints = differences(walk, now);
  for (int j = 0; j < body_joint_count; ++j)
    EXPECT_EQ(joints[j].differs_itself(), j == RightKnee) << joints[j].name;
  EXPECT_NEAR(peak_of(joints[RightKnee].offset_m).value,
              0.01 * walk.body.joints[RightKnee].offset.norm(), 1e-12);
}

TEST(PeakOfACurve, IsItsFirstLargestValue) {
  EXPECT_EQ(peak_of(std::vector{1.0, 3.0, 2.0, 3.0}).frame, 1);
  EXPECT_EQ(peak_of({}).value, 0.0);
  EXPECT_NEAR(root_mean_square(std::vector{3.0, 4.0}), std::sqrt(12.5), 1e-15);
}

}  // namespace
}  // namespace mien::motion
