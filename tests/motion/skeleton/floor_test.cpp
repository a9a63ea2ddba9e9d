#include "motion/skeleton/floor.h"

#include <gtest/gtest.h>

#include "motion/skeleton/sole.h"
#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(Sole, OfTheStandardBodyLiesAtTheFloor) {
  Pose pose;
  pose.rotations.assign(body_joint_count, Quat::Identity());
  pose.root_position = Vec3(0, 0.96, 0);
  const Skeleton body = standard_body();
  const SolePoints left = sole_points(body, world_transforms(body, pose), true);
  EXPECT_NEAR(left.heel.y(), 0.0, 1e-9);
  EXPECT_NEAR(left.ball.y(), 0.0, 1e-9);
  EXPECT_NEAR(left.tip.y(), 0.0, 1e-9);
  EXPECT_GT(left.heel.x(), 0.0);
  EXPECT_LT(left.heel.z(), left.ball.z());
  EXPECT_LT(left.ball.z(), left.tip.z());
}

TEST(Floor, IsWhereFeetRest) {
  Clip clip = synthetic_clip(steady_walk(1.2, 3.0));
  EXPECT_NEAR(floor_height(clip), 0.0, 1e-3);
  for (Pose& pose : clip.poses) pose.root_position.y() += 0.37;
  EXPECT_NEAR(floor_height(clip), 0.37, 1e-3);
}

TEST(Floor, IsNotMovedByAFewBadFrames) {
  Clip clip = synthetic_clip(steady_walk(1.2, 5.0));
  for (int t = 200; t < 204; ++t) clip.poses[t].root_position.y() -= 0.5;
  EXPECT_NEAR(floor_height(clip), 0.0, 5e-3);
}

TEST(Floor, IsUnderTheFeetAndNotUnderToesThatDip) {
  // A foot without a toe joint rolls off on the end of its toes, which dip far below the floor.
  Clip clip = synthetic_clip(steady_walk(1.2, 4.0));
  for (Pose& pose : clip.poses) {
    for (const BodyJoint toe : {LeftToe, RightToe}) pose.rotations[toe] = exp(Vec3(0.6, 0, 0));
  }
  EXPECT_NEAR(floor_height(clip), 0.0, 2e-3);
}

TEST(Floor, IsUnderTheLowerOfFeetThatStandUnlike) {
  // One ankle was marked 3 cm higher than the other.
  Clip clip = synthetic_clip(steady_walk(1.2, 4.0));
  clip.body.joints[LeftAnkle].offset.y() += 0.03;
  EXPECT_NEAR(floor_height(clip), 0.0, 4e-3);
}

TEST(Floor, IsTheLowestOfSeveralLevels) {
  Clip clip = synthetic_clip(steady_walk(1.2, 6.0));
  for (int t = 300; t < clip.frame_count(); ++t) clip.poses[t].root_position.y() += 0.2;
  EXPECT_NEAR(floor_height(clip), 0.0, 2e-3);
}

TEST(Floor, ThatSlopesIsLevelled) {
  for (const double degrees : {-4.0, -2.6, -0.9, 0.7, 2.0, 5.0}) {
    SyntheticWalk walk = steady_walk(1.2, 5.0);
    walk.heading = 0.8;
    Clip clip = synthetic_clip(walk);
    const Vec3 direction(std::sin(0.8), 0, std::cos(0.8));
    const Quat tilt = about(direction.cross(Vec3::UnitY()), degrees * radians_per_degree);
    for (Pose& pose : clip.poses) {
      pose.root_position = tilt * pose.root_position;
      pose.rotations[Pelvis] = tilt * pose.rotations[Pelvis];
    }
    const Quat levelling = floor_levelling(clip);
    EXPECT_LT(angle_between(levelling * tilt, Quat::Identity()), 0.3 * radians_per_degree)
        << degrees;
  }
}

TEST(Floor, ThatIsLevelStays) {
  const Clip clip = synthetic_clip(steady_walk(1.2, 5.0));
  EXPECT_EQ(floor_levelling(clip).coeffs(), Quat::Identity().coeffs());
  SyntheticWalk still;
  still.distance.assign(300, 0.3);
  EXPECT_EQ(floor_levelling(synthetic_clip(still)).coeffs(), Quat::Identity().coeffs());
}

}  // namespace
}  // namespace mien::motion
