#include "motion/rig/retarget.h"

#include <gtest/gtest.h>

#include "motion/skeleton/floor.h"
#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(Retarget, ToItsOwnBodyChangesNothing) {
  const Clip clip = synthetic_clip(steady_walk(1.2, 2.0));
  const Clip same = retarget(clip, clip.body);
  for (size_t t = 0; t < clip.poses.size(); ++t) {
    EXPECT_NEAR((same.poses[t].root_position - clip.poses[t].root_position).norm(), 0.0, 1e-12);
  }
}

TEST(Retarget, ToALargerBodyTakesLargerStepsOnTheSameFloor) {
  const Clip clip = synthetic_clip(steady_walk(1.2, 2.0));
  const Clip large = retarget(clip, standard_body(2.1));
  const double ratio = 2.1 / 1.75;
  const Vec3 way = large.poses.back().root_position - large.poses.front().root_position;
  EXPECT_NEAR(way.z(), 2.4 * ratio, 1e-9);
  EXPECT_NEAR(floor_height(large), floor_height(clip), 1e-9);
  // A similar body stays similar: planted feet stay planted.
  const auto small_path = joint_paths(clip);
  const auto large_path = joint_paths(large);
  EXPECT_NEAR((large_path[130][LeftAnkle] - ratio * small_path[130][LeftAnkle]).norm(), 0.0, 0.01);
}

TEST(Retarget, StandsOnTheFloorWithHigherAnkles) {
  const Clip clip = synthetic_clip(steady_walk(1.2, 2.0));
  Skeleton body = clip.body;
  for (const int toe : {LeftToe, RightToe}) body.joints[toe].offset.y() -= 0.05;
  const Clip high = retarget(clip, body);
  EXPECT_NEAR(floor_height(high), floor_height(clip), 1e-9);
  EXPECT_NEAR(high.poses[0].root_position.y() - clip.poses[0].root_position.y(), 0.05, 2e-3);
}

}  // namespace
}  // namespace mien::motion
