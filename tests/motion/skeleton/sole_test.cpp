#include "motion/skeleton/sole.h"

#include <gtest/gtest.h>

#include "motion/gait/foot_path.h"
#include "motion/modify/posture.h"
#include "motion/procedural/foot_roll.h"
#include "motion/skeleton/body.h"

namespace mien::motion {
namespace {

TEST(Sole, LiesOnTheFloorUnderABodyThatStands) {
  for (const double height : {1.2, 1.65, 1.75, 2.1}) {
    for (const Skeleton& body : {standard_body(height), standard_female_body(height)}) {
      const JointTransforms world = world_transforms(body, standing_pose(body));
      for (const bool left : {true, false}) {
        const SolePoints sole = sole_points(body, world, left);
        EXPECT_NEAR(sole.heel.y(), 0.0, 1e-12) << height;
        EXPECT_NEAR(sole.ball.y(), 0.0, 1e-12) << height;
        EXPECT_LT(sole.heel.z(), sole.ball.z());
        EXPECT_LT(sole.ball.z(), sole.tip.z());
      }
    }
  }
}

TEST(Sole, GrowsWithTheBody) {
  const SoleShape small = sole_shape(standard_body(1.4), true);
  const SoleShape tall = sole_shape(standard_body(2.1), true);
  EXPECT_NEAR(tall.depth, 1.5 * small.depth, 1e-12);
  EXPECT_LT((tall.heel - 1.5 * small.heel).norm(), 1e-12);
  EXPECT_LT((tall.ball - 1.5 * small.ball).norm(), 1e-12);
  EXPECT_LT((tall.toes - 1.5 * small.toes).norm(), 1e-12);
}

TEST(Sole, IsThatOfTheWalkerAndOfTheFootLock) {
  Clip clip;
  clip.body = standard_female_body(1.62);
  clip.poses = {standing_pose(clip.body)};
  const SoleShape sole = sole_shape(clip.body, false);
  const FootShape foot = foot_shape(clip.body, RightAnkle);
  EXPECT_EQ(foot.heel, sole.heel);
  EXPECT_EQ(foot.ball_height, sole.depth);
  EXPECT_EQ(foot.ankle_height, -sole.ball.y());
  EXPECT_EQ(foot_path(clip, false).sole_depth, sole.depth);
}

TEST(RelativeStature, IsOneOfTheStandardBody) {
  EXPECT_NEAR(relative_stature(standard_body()), 1.0, 1e-12);
  EXPECT_NEAR(relative_stature(standard_body(3.5)), 2.0, 1e-12);
  // Stature is what stands above the joints and the soles below them.
  const Skeleton body = standard_body(1.9);
  EXPECT_NEAR(standing_height(body) + sole_depth(body), 1.9, 1e-12);
}

}  // namespace
}  // namespace mien::motion
