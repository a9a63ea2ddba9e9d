#include "motion/style_transfer/motion_warp.h"

#include <gtest/gtest.h>

#include "motion/refusal.h"
#include "motion/style_transfer/motion_curves.h"

#include "reach.h"
#include "walk_pair.h"

namespace mien::motion {
namespace {

using namespace mien::test;

Quat about(const Vec3& axis, double angle) { return Quat(Eigen::AngleAxisd(angle, axis)); }

const Quat nodding = about(Vec3::UnitX(), 0.3);

/// A key in which some joints are turned.
WarpKey key_at(double seconds, std::vector<JointKey> joints) {
  WarpKey key;
  key.seconds = seconds;
  key.joints = std::move(joints);
  return key;
}

TEST(MotionWarp, PassesThroughItsKeys) {
  const Clip motion = reach(2.0, 0.8);
  for (const WarpBy by : {WarpBy::offset, WarpBy::scale}) {
    const auto keys = {key_at(0.5, {{RightShoulder, nodding, by}, {Head, nodding, by}}),
                       key_at(1.0, {{RightShoulder, nodding.conjugate(), by}})};
    const Clip result = motion_warped(motion, keys);
    EXPECT_LT(angle_between(result.poses[30].rotations[RightShoulder],
                            nodding * motion.poses[30].rotations[RightShoulder]),
              1e-9);
    EXPECT_LT(
        angle_between(result.poses[30].rotations[Head], nodding * motion.poses[30].rotations[Head]),
        1e-9);
    EXPECT_LT(angle_between(result.poses[60].rotations[RightShoulder],
                            nodding.conjugate() * motion.poses[60].rotations[RightShoulder]),
              1e-9);
    EXPECT_LT(largest_pop(result), 0.02);
  }
}

TEST(MotionWarp, IsTheMotionAwayFromItsKeys) {
  const Clip motion = reach(2.0, 0.8);
  const Clip result =
      motion_warped(motion, {key_at(0.5, {{Head, nodding}}), key_at(1.5, {{Head, nodding}})},
                    {.reach_seconds = 0.3});
  for (int i = 0; i < motion.frame_count(); ++i) {
    const double t = i / 60.0;
    const double away = std::min(std::abs(t - 0.5), std::abs(t - 1.5));
    const double turned =
        angle_between(result.poses[i].rotations[Head], motion.poses[i].rotations[Head]);
    if (away >= 0.3) {
      EXPECT_LT(turned, 1e-9) << i;
    } else {
      EXPECT_GT(turned, 1e-9) << i;
    }
    EXPECT_LT(
        angle_between(result.poses[i].rotations[RightElbow], motion.poses[i].rotations[RightElbow]),
        1e-9);
  }
}

TEST(MotionWarp, MovesKeysInTime) {
  const Clip motion = reach(2.0, 0.8);
  WarpKey peak;
  peak.seconds = 1.0;
  peak.at = 0.6;
  const Clip result = motion_warped(motion, {peak});
  ASSERT_EQ(result.frame_count(), motion.frame_count());
  EXPECT_LT(angle_between(result.poses[36].rotations[RightShoulder],
                          motion.poses[60].rotations[RightShoulder]),
            1e-9);
  EXPECT_LT(angle_between(result.poses.back().rotations[RightShoulder],
                          motion.poses.back().rotations[RightShoulder]),
            1e-9);
  const Clip longer = motion_warped(motion, {}, {.duration_seconds = 3.0});
  EXPECT_EQ(longer.frame_count(), 181);
}

TEST(MotionWarp, WorksAcrossTheSeamOfALoop) {
  const Clip walk = builtin_walk("normal").clip;
  const Clip result = motion_warped(walk, {key_at(0.0, {{Head, nodding}})}, {.reach_seconds = 0.2});
  const auto turned = [&](int i) {
    return angle_between(result.poses[i].rotations[Head], walk.poses[i].rotations[Head]);
  };
  const int last = walk.frame_count() - 1;
  EXPECT_NEAR(turned(0), 0.3, 1e-9);
  EXPECT_NEAR(turned(1), turned(last), 1e-4);
  EXPECT_GT(turned(last), 0.1);
  EXPECT_LT(turned(walk.frame_count() / 2), 1e-9);
}

TEST(MotionWarp, OfNoAmountIsTheMotion) {
  const Example normal = builtin_walk("normal");
  EXPECT_LT(
      largest_difference(warped_towards(normal, builtin_walk("sad"), {.amount = 0.0}), normal.clip),
      1e-9);
}

TEST(MotionWarp, TowardsTheMotionItselfChangesNothing) {
  const Example sad = builtin_walk("sad");
  EXPECT_LT(largest_difference(warped_towards(sad, sad, {.amount = 1.5}), sad.clip), 1e-9);
}

TEST(MotionWarp, ReachesTheStyledPosesAtTheKeytimes) {
  const Example normal = builtin_walk("normal");
  const Example sad = builtin_walk("sad");
  const Clip result = warped_towards(normal, sad);
  EXPECT_EQ(result.frame_count(), sad.clip.frame_count());
  EXPECT_NEAR((result.cycle_displacement - sad.clip.cycle_displacement).norm(), 0.0, 1e-9);
  for (const double keytime : sad.keytimes) {
    const Pose here = pose_at(result, keytime);
    const Pose there = pose_at(sad.clip, keytime);
    for (int j = 0; j < body_joint_count; ++j) {
      // Keytimes lie between frames.
      EXPECT_LT(angle_between(here.rotations[j], there.rotations[j]), 0.03) << j << " " << keytime;
    }
  }
  EXPECT_LT(largest_difference(result, sad.clip), 0.4);
}

TEST(MotionWarp, ExaggeratesMonotonically) {
  const Example normal = builtin_walk("normal");
  double bent = -1.0;
  for (const double amount : {0.0, 0.5, 1.0, 1.5}) {
    const Clip result = warped_towards(normal, builtin_walk("sad"), {.amount = amount});
    const auto means = mean_rotations(result);
    EXPECT_GT(log(means[Neck] * means[Head]).x(), bent) << amount;
    bent = log(means[Neck] * means[Head]).x();
  }
}

TEST(MotionWarp, RefusesKeysThatCannotBe) {
  const Clip motion = reach(2.0, 0.8);
  EXPECT_NE(refusal_of([&] {
              motion_warped(motion, {key_at(2.5, {})});
            }).find("2500 ms is outside the motion, which lasts 2000 ms"),
            std::string::npos);
  EXPECT_NE(refusal_of([&] {
              motion_warped(motion, {key_at(0.5, {}), key_at(0.5, {})});
            }).find("two keys are at 500 ms"),
            std::string::npos);
  WarpKey early = key_at(0.5, {});
  early.at = 1.2;
  WarpKey late = key_at(1.0, {});
  late.at = 1.1;
  EXPECT_NE(refusal_of([&] {
              motion_warped(motion, {early, late});
            }).find("out of order"),
            std::string::npos);
}

}  // namespace
}  // namespace mien::motion
