#include "motion/biomechanics/support.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/biomechanics/body_mass.h"
#include "motion/math/rotation.h"
#include "motion/modify/posture.h"

namespace mien::motion {
namespace {

TEST(Support, DistanceOutsideIsToTheHull) {
  const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}, {0.5, 0, 0.5}};
  EXPECT_NEAR(distance_outside(Vec3(0.5, 3, 0.4), square), -0.4, 1e-12);
  EXPECT_NEAR(distance_outside(Vec3(1.25, 0, 0.5), square), 0.25, 1e-12);
  EXPECT_NEAR(distance_outside(Vec3(2, 0, 2), square), std::sqrt(2.0), 1e-12);
  EXPECT_TRUE(nearest_in(Vec3(2, 5, 2), square).isApprox(Vec3(1, 0, 1)));
  EXPECT_TRUE(nearest_in(Vec3(0.3, 5, 0.7), square).isApprox(Vec3(0.3, 0, 0.7)));
  EXPECT_NEAR(distance_outside(Vec3(3, 0, 4), {Vec3::Zero()}), 5.0, 1e-12);
}

TEST(StandingMargin, IsWithinTheSolesOfABodyThatStandsUpright) {
  const Skeleton body = standard_body();
  EXPECT_GT(standing_margin(body, standing_pose(body)), 0.02);
  Pose falling = standing_pose(body);
  falling.rotations[Pelvis] = exp(Vec3(0.5, 0, 0));
  EXPECT_LT(standing_margin(body, falling), 0.0);
  Pose leaning = standing_pose(body);
  leaning.rotations[Pelvis] = exp(Vec3(-0.05, 0, 0));
  EXPECT_LT(standing_margin(body, leaning), standing_margin(body, standing_pose(body)) - 0.02);
}

TEST(StandingMargin, GrowsWithTheBody) {
  const Skeleton small = standard_body(1.4);
  const Skeleton tall = standard_body(2.1);
  EXPECT_NEAR(standing_margin(tall, standing_pose(tall)),
              1.5 * standing_margin(small, standing_pose(small)), 1e-9);
}

TEST(StandingMargin, IsThatOfAClipThatStandsStill) {
  Clip still;
  still.body = standard_female_body(1.7);
  still.frames_per_second = 60.0;
  Pose pose = standing_pose(still.body);
  pose.rotations[Pelvis] = exp(Vec3(0, 0, 0.02));
  pose.rotations[LeftAnkle] = pose.rotations[RightAnkle] = exp(Vec3(0, 0, -0.02));
  still.poses.assign(60, pose);
  const LintSubject subject = lint_subject(still);
  const Support support = supports(subject)[30];
  ASSERT_FALSE(support.left.empty());
  ASSERT_FALSE(support.right.empty());
  const Vec3 mass = centre_of_mass(still.body, subject.world[30]);
  EXPECT_NEAR(standing_margin(still.body, pose), -distance_outside(mass, support.all()), 1e-12);
}

TEST(StandingMargin, RestsOnNoFootThatIsLifted) {
  const Skeleton body = standard_body();
  Pose pose = standing_pose(body);
  pose.rotations[LeftHip] = exp(Vec3(-1.0, 0, 0));
  pose.rotations[LeftKnee] = exp(Vec3(1.0, 0, 0));
  const JointTransforms world = world_transforms(body, pose);
  EXPECT_TRUE(standing_support(body, world).left.empty());
  EXPECT_EQ(standing_support(body, world).right.size(), 6u);
  EXPECT_LT(standing_margin(body, pose), 0.0);
}

}  // namespace
}  // namespace mien::motion
