#include "motion/style_transfer/motion_curves.h"

#include <random>

#include <gtest/gtest.h>

#include "motion/random_motion.h"
#include "motion/refusal.h"

#include "walk_pair.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(MotionCurves, AreTheMotionAgain) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 20; ++trial) {
    Clip clip = random_loop(random, 25 + trial, 30.0, 1.0).clip;
    EXPECT_LT(largest_difference(to_clip(to_curves(clip)), clip), 1e-9);
    clip.loops = false;
    clip.cycle_displacement = Vec3::Zero();
    EXPECT_LT(largest_difference(to_clip(to_curves(clip)), clip), 1e-9);
  }
}

TEST(MotionCurves, DoNotDependOnWhereTheMotionHeads) {
  const Clip clip = builtin_walk("sad").clip;
  Clip turned = clip;
  const Quat turn(Eigen::AngleAxisd(2.0, Vec3::UnitY()));
  turned.cycle_displacement = turn * clip.cycle_displacement;
  for (Pose& pose : turned.poses) {
    pose.root_position = turn * pose.root_position + Vec3(3, 0, -4);
    pose.rotations[Pelvis] = turn * pose.rotations[Pelvis];
  }
  const MotionCurves curves = to_curves(clip);
  const MotionCurves others = to_curves(turned);
  EXPECT_LT((curves.values - others.values).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((curves.way - others.way).norm(), 1e-9);
  EXPECT_LT(largest_difference(to_clip(others), turned), 1e-9);
}

TEST(MotionCurves, GoOnBeyondHalfATurn) {
  // A joint that turns by three quarters of a full turn either way: no jump by 2π.
  Clip clip = builtin_walk("normal").clip;
  const int frames = clip.frame_count();
  for (int i = 0; i < frames; ++i) {
    const double angle = 1.5 * pi * std::sin(2.0 * pi * i / frames);
    clip.poses[i].rotations[LeftShoulder] = Quat(Eigen::AngleAxisd(angle, Vec3::UnitX()));
  }
  const MotionCurves curves =
      to_curves(clip, std::vector<Quat>(body_joint_count, Quat::Identity()));
  for (int i = 1; i < frames; ++i) {
    EXPECT_LT((curves.values.block<1, 3>(i, first_curve(LeftShoulder)) -
               curves.values.block<1, 3>(i - 1, first_curve(LeftShoulder)))
                  .norm(),
              1.2)
        << i;
  }
}

TEST(MotionCurves, BetweenFramesMeetThem) {
  const MotionCurves curves = to_curves(builtin_walk("happy").clip);
  const int frames = curves.frame_count();
  for (int i = 0; i < frames; ++i) {
    EXPECT_EQ(curves_at(curves, static_cast<double>(i) / frames), curves.values.row(i));
  }
  const MotionCurves there_and_back = resampled(resampled(curves, 4 * frames), frames);
  EXPECT_LT((there_and_back.values - curves.values).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(MotionCurves, OfTooFewFramesAreRefused) {
  Clip clip = builtin_walk("happy").clip;
  clip.name = "hop";
  clip.poses.resize(3);
  EXPECT_NE(refusal_of([&] { to_curves(clip); }).find("\"hop\" has fewer than 4 frames"),
            std::string::npos);
}

}  // namespace
}  // namespace mien::motion
