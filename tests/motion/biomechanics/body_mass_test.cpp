#include "motion/biomechanics/body_mass.h"

#include <random>

#include <gtest/gtest.h>

#include "motion/random_motion.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/mirror.h"

namespace mien::motion {
namespace {

constexpr std::array models = {MassModel::de_leva_male, MassModel::de_leva_female,
                               MassModel::winter};

JointTransforms standing_joints(const Skeleton& body) {
  Pose pose;
  pose.rotations.assign(body_joint_count, Quat::Identity());
  return world_transforms(body, pose);
}

TEST(BodyMass, SegmentsAddUpToOneBody) {
  const Skeleton body = standard_body();
  for (const MassModel model : models) {
    double sum = 0.0;
    for (const SegmentMass& segment : segment_masses(body, standing_joints(body), model)) {
      sum += segment.share;
    }
    // The published shares are rounded.
    EXPECT_NEAR(sum, 1.0, model == MassModel::de_leva_male ? 1e-12 : 1.2e-3);
  }
}

TEST(BodyMass, TheCentreOfASegmentDividesItAsPublished) {
  const Skeleton body = standard_body();
  const JointTransforms pose = standing_joints(body);
  for (const SegmentMass& segment : segment_masses(body, pose)) {
    if (segment.name != "left thigh") continue;
    const Vec3 hip = pose.positions[LeftHip];
    const Vec3 knee = pose.positions[LeftKnee];
    EXPECT_DOUBLE_EQ(segment.share, 0.1416);
    EXPECT_NEAR((segment.centre - hip).norm() / (knee - hip).norm(), 0.4095, 1e-12);
    return;
  }
  FAIL() << "there is no left thigh";
}

TEST(BodyMass, TheHandsCentreLiesBeyondTheWristInProportionToStature) {
  for (const double height : {1.5, 1.741, 1.9}) {
    const Skeleton body = standard_body(height);
    const JointTransforms pose = standing_joints(body);
    for (const SegmentMass& segment : segment_masses(body, pose)) {
      if (segment.name != "right hand") continue;
      const Vec3 beyond = segment.centre - pose.positions[RightWrist];
      EXPECT_NEAR(beyond.norm(), 0.068 * standing_height(body) / 1.741, 2e-4);
      EXPECT_LT(beyond.x(), 0.0);
    }
  }
}

TEST(BodyMass, AStandingAdultsCentreIsAtHalfToThreeFifthsOfStature) {
  // With the arms spread the centre is a little higher than the 55–57 % of anatomical standing.
  const Skeleton body = standard_body();
  const double sole = standing_joints(body).positions[LeftToe].y() - 0.02;
  for (const MassModel model : models) {
    const double height = centre_of_mass(body, standing_joints(body), model).y() - sole;
    EXPECT_GT(height / standing_height(body), 0.53);
    EXPECT_LT(height / standing_height(body), 0.61);
  }
}

TEST(BodyMass, MovesTurnsAndMirrorsWithTheBody) {
  std::mt19937_64 random(5);
  const Clip clip = test::random_loop(random, 20).clip;
  const Quat turn(Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()));
  const Vec3 shift(0.3, -2.0, 5.0);
  for (Pose pose : clip.poses) {
    const Vec3 before = centre_of_mass(clip.body, world_transforms(clip.body, pose));
    const Vec3 image = centre_of_mass(clip.body, world_transforms(clip.body, mirrored(pose)));
    EXPECT_NEAR((image - mirrored_place(before)).norm(), 0.0, 1e-12);
    pose.root_position = turn * pose.root_position + shift;
    pose.rotations[Pelvis] = turn * pose.rotations[Pelvis];
    const Vec3 after = centre_of_mass(clip.body, world_transforms(clip.body, pose));
    EXPECT_NEAR((after - (turn * before + shift)).norm(), 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace mien::motion
