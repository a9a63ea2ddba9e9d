#include "motion/rig/toe_bend.h"

#include <gtest/gtest.h>

#include "motion/skeleton/sole.h"
#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(ToeBend, KeepsTheToesOnTheFloorAsAFootRollsOff) {
  // The left foot is lifted behind: it turns about its ball, which stays on the floor.
  Clip clip = synthetic_clip(steady_walk(0.0, 1.0));
  for (int t = 0; t < clip.frame_count(); ++t) {
    const Quat lifted = about(Vec3::UnitX(), 0.01 * t);
    Pose& pose = clip.poses[t];
    pose.rotations[LeftAnkle] *= lifted;
    const Vec3 ball = sole_points(clip.body, world_transforms(clip.body, pose), true).ball;
    pose.root_position.y() -= ball.y();
  }
  const Clip stiff = clip;
  bend_toes_at_floor(clip, LeftToe);
  double lowest = 0.0;
  for (int t = 0; t < clip.frame_count(); ++t) {
    const auto tip_of = [&](const Clip& one) {
      return sole_points(one.body, world_transforms(one.body, one.poses[t]), true).tip;
    };
    lowest = std::min(lowest, tip_of(stiff).y());
    EXPECT_GT(tip_of(clip).y(), -1e-6) << t;
    // Nothing but the toes.
    EXPECT_EQ(clip.poses[t].rotations[LeftAnkle].coeffs(),
              stiff.poses[t].rotations[LeftAnkle].coeffs());
    EXPECT_EQ(clip.poses[t].rotations[RightToe].coeffs(),
              stiff.poses[t].rotations[RightToe].coeffs());
  }
  EXPECT_LT(lowest, -0.04);
}

TEST(ToeBend, LeavesToesAloneThatAreAbove) {
  Clip clip = synthetic_clip(steady_walk(1.2, 2.0));
  const Clip before = clip;
  bend_toes_at_floor(clip, RightToe);
  for (int t = 0; t < clip.frame_count(); ++t) {
    EXPECT_LT(angle_between(clip.poses[t].rotations[RightToe], before.poses[t].rotations[RightToe]),
              1e-6);
  }
}

}  // namespace
}  // namespace mien::motion
