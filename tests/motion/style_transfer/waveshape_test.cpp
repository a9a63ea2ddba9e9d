#include "motion/style_transfer/waveshape.h"

#include <gtest/gtest.h>

#include "motion/refusal.h"
#include "motion/style_transfer/motion_curves.h"

#include "walk_pair.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(Waveshape, IsTheIdentityInsideItsLimits) {
  const Waveshape soft{-0.3, 0.5, 0.1};
  for (double angle = -0.3; angle <= 0.5; angle += 0.05) EXPECT_EQ(shaped(soft, angle), angle);
}

TEST(Waveshape, GoesSmoothlyIntoItsLimitAndNeverBeyond) {
  const Waveshape soft{-0.3, 0.5, 0.1};
  const double h = 1e-7;
  EXPECT_NEAR((shaped(soft, 0.5 + h) - shaped(soft, 0.5)) / h, 1.0, 1e-5);
  EXPECT_NEAR((shaped(soft, -0.3) - shaped(soft, -0.3 - h)) / h, 1.0, 1e-5);
  EXPECT_NEAR(shaped(soft, 0.6), 0.5 + 0.1 * (1.0 - std::exp(-1.0)), 1e-12);
  EXPECT_LE(shaped(soft, 10.0), 0.6);
  EXPECT_GE(shaped(soft, -10.0), -0.4);
}

TEST(Waveshape, WithoutSoftnessIsAHardLimit) {
  EXPECT_DOUBLE_EQ(shaped({-0.3, 0.5, 0.0}, 0.9), 0.5);
  EXPECT_DOUBLE_EQ(shaped({-0.3, 0.5, 0.0}, -0.9), -0.3);
}

TEST(Waveshape, PassesThroughItsPointsAndGoesOnStraight) {
  Waveshape shape;
  shape.points = {{-1.0, -0.2}, {0.0, 0.0}, {1.0, 0.8}};
  for (const auto& [angle, to] : shape.points) EXPECT_NEAR(shaped(shape, angle), to, 1e-15);
  EXPECT_NEAR(shaped(shape, 1.5), 1.2, 1e-12);
  EXPECT_NEAR(shaped(shape, -2.0), -0.4, 1e-12);
}

TEST(Waveshaped, KeepsTheMotionInsideTheLimits) {
  const Clip walk = builtin_walk("brisk").clip;
  std::vector<JointWaveshape> shapes;
  for (int j = 0; j < body_joint_count; ++j) shapes.push_back({BodyJoint(j), {}, {-3.0, 3.0, 0.1}});
  EXPECT_LT(largest_difference(waveshaped(walk, shapes), walk), 1e-9);
  for (JointWaveshape& shape : shapes) shape.shape = {-0.1, 0.1, 0.05};
  EXPECT_LT(largest_difference(waveshaped(walk, shapes, {.amount = 0.0}), walk), 1e-9);
}

TEST(Waveshaped, LimitsTheSwingOfOneJoint) {
  const Clip walk = builtin_walk("brisk").clip;
  const double limit = 0.1;
  const Clip result = waveshaped(walk, {{LeftShoulder, {}, {-limit, limit, 0.05}}});
  const std::vector<Quat> means = mean_rotations(walk);
  double widest = 0.0;
  for (int i = 0; i < walk.frame_count(); ++i) {
    const Quat& rotation = result.poses[i].rotations[LeftShoulder];
    const double angle = angle_between(means[LeftShoulder], rotation);
    widest = std::max(widest, angle);
    const Quat& before = walk.poses[i].rotations[LeftShoulder];
    if (angle_between(means[LeftShoulder], before) < limit) {
      EXPECT_LT(angle_between(before, rotation), 1e-7);
    }
    EXPECT_LT(angle_between(walk.poses[i].rotations[RightShoulder],
                            result.poses[i].rotations[RightShoulder]),
              1e-7);
  }
  EXPECT_LE(widest, limit + 0.05);
  EXPECT_GT(widest, limit);
}

TEST(Waveshaped, AboutAnAxisLeavesTheOthers) {
  const Clip walk = builtin_walk("brisk").clip;
  const Clip result = waveshaped(walk, {{LeftHip, Vec3(Vec3::UnitX()), {-0.1, 0.1, 0.0}}});
  const std::vector<Quat> means = mean_rotations(walk);
  const MotionCurves before = to_curves(walk, means);
  const MotionCurves after = to_curves(result, means);
  const int x = first_curve(LeftHip);
  EXPECT_LT(after.values.col(x).cwiseAbs().maxCoeff(), 0.1 + 1e-9);
  EXPECT_GT(before.values.col(x).cwiseAbs().maxCoeff(), 0.2);
  EXPECT_LT((after.values.middleCols<2>(x + 1) - before.values.middleCols<2>(x + 1))
                .cwiseAbs()
                .maxCoeff(),
            1e-9);
}

TEST(Waveshaped, BySwingRatiosMovesAsWidelyAsTheStyledMotion) {
  const Clip normal = builtin_walk("normal").clip;
  const Clip sad = builtin_walk("sad").clip;
  const auto rms = [](const Clip& clip, int joint) {
    return to_curves(clip).values.middleCols<3>(first_curve(joint)).norm() /
           std::sqrt(clip.frame_count());
  };
  double previous = HUGE_VAL;
  for (const double amount : {0.0, 0.5, 1.0, 1.5}) {
    const Clip result = waveshaped(normal, shapes_between(normal, sad), {.amount = amount});
    if (amount == 1.0) {
      EXPECT_NEAR(rms(result, LeftShoulder), rms(sad, LeftShoulder), 1e-3);
    }
    EXPECT_LT(rms(result, LeftShoulder), previous);
    previous = rms(result, LeftShoulder);
  }
  EXPECT_LT(largest_difference(waveshaped(normal, shapes_between(sad, sad)), normal), 1e-9);
}

TEST(Waveshaped, RefusesLimitsTheWrongWayRound) {
  const Clip walk = builtin_walk("brisk").clip;
  EXPECT_NE(refusal_of([&] {
              waveshaped(walk, {{LeftHip, {}, {0.2, -0.2, 0.1}}});
            }).find("LeftHip has its lower limit above"),
            std::string::npos);
  JointWaveshape folded{LeftHip, {}, {}};
  folded.shape.points = {{0.0, 0.0}, {0.0, 1.0}};
  EXPECT_NE(refusal_of([&] { waveshaped(walk, {folded}); }).find("not in ascending order"),
            std::string::npos);
}

}  // namespace
}  // namespace mien::motion
