#include "motion/style_transfer/drives.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "walk_pair.h"

namespace mien::motion {
namespace {

using namespace mien::test;

constexpr DriveQuantity all_quantities[] = {
    DriveQuantity::left_hand_forward,  DriveQuantity::left_hand_side,
    DriveQuantity::left_hand_height,   DriveQuantity::left_hand_distance,
    DriveQuantity::right_hand_forward, DriveQuantity::right_hand_side,
    DriveQuantity::right_hand_height,  DriveQuantity::right_hand_distance,
    DriveQuantity::torso_bend,         DriveQuantity::head_bend,
    DriveQuantity::pelvis_height};

TEST(Drive, RecoversSlopeAndIntercept) {
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  std::vector<double> x;
  std::vector<double> exact;
  std::vector<double> noisy;
  for (int i = 0; i < 2000; ++i) {
    x.push_back(normal(random));
    exact.push_back(1.7 * x.back() - 0.3);
    noisy.push_back(exact.back() + normal(random));
  }
  EXPECT_NEAR(drive_between(x, exact).slope, 1.7, 1e-12);
  EXPECT_NEAR(drive_between(x, exact).intercept, -0.3, 1e-12);
  EXPECT_NEAR(drive_between(x, exact).r_squared, 1.0, 1e-12);
  // Standard error of the slope 1/√2000; r² = 1.7² / (1.7² + 1).
  EXPECT_NEAR(drive_between(x, noisy).slope, 1.7, 0.09);
  EXPECT_NEAR(drive_between(x, noisy).r_squared, 0.743, 0.03);
}

TEST(Drive, OfAStillQuantityIsItsValue) {
  const Drive drive = drive_between({0.5, 0.5, 0.5}, {1.0, 2.0, 3.0});
  EXPECT_EQ(drive.slope, 0.0);
  EXPECT_DOUBLE_EQ(drive.intercept, 2.0);
  EXPECT_EQ(drive.r_squared, 0.0);
}

TEST(Driven, QuantitiesAreWhatTheEditSays) {
  const Clip walk = builtin_walk("brisk").clip;
  for (const DriveQuantity quantity : all_quantities) {
    const std::vector<double> before = quantity_of(walk, quantity);
    // Little enough to stay within reach: hands come nearer, the pelvis sinks.
    const double scale = quantity == DriveQuantity::pelvis_height ? 1.0 : 0.95;
    const DriveEdit edit{quantity, scale, -0.02, {}};
    const Clip result = driven(walk, {edit});
    const std::vector<double> after = quantity_of(result, quantity);
    for (size_t i = 0; i < before.size(); ++i) {
      EXPECT_NEAR(after[i], scale * before[i] - 0.02, 1e-6) << name_of(quantity) << " " << i;
    }
    EXPECT_LT(largest_pop(result), largest_pop(walk) + 0.05) << name_of(quantity);
  }
}

TEST(Driven, HandsKeepTheirOrientationAndTheOtherArmItsPlace) {
  const Clip walk = builtin_walk("brisk").clip;
  const Clip result = driven(walk, {{DriveQuantity::left_hand_forward, 1.0, 0.1, {}}});
  for (size_t i = 0; i < walk.poses.size(); ++i) {
    const JointTransforms before = world_transforms(walk.body, walk.poses[i]);
    const JointTransforms after = world_transforms(result.body, result.poses[i]);
    EXPECT_LT(angle_between(before.rotations[LeftWrist], after.rotations[LeftWrist]), 1e-7);
    EXPECT_LT((before.positions[RightWrist] - after.positions[RightWrist]).norm(), 1e-12);
    EXPECT_GT((before.positions[LeftWrist] - after.positions[LeftWrist]).norm(), 0.05);
  }
}

TEST(Driven, AnklesStayWhenThePelvisSinks) {
  const Clip walk = builtin_walk("normal").clip;
  const Clip result = driven(walk, {{DriveQuantity::pelvis_height, 1.0, -0.05, {}}});
  const auto before = joint_paths(walk);
  const auto after = joint_paths(result);
  for (size_t i = 0; i < before.size(); ++i) {
    for (const int foot : {LeftAnkle, LeftToe, RightAnkle, RightToe}) {
      EXPECT_LT((before[i][foot] - after[i][foot]).norm(), 1e-6) << i;
    }
    EXPECT_NEAR(before[i][Pelvis].y() - after[i][Pelvis].y(), 0.05, 1e-12);
  }
}

TEST(Driven, CorrelatedQuantitiesMoveAlong) {
  // The torso of a walk bends twice a cycle, and so does the head against it.
  const Clip walk = builtin_walk("brisk").clip;
  const auto torso = quantity_of(walk, DriveQuantity::torso_bend);
  const auto head = quantity_of(walk, DriveQuantity::head_bend);
  const Drive drive = drive_between(torso, head);
  ASSERT_GT(std::abs(drive.slope), 0.05);
  const Clip result =
      driven(walk, {{DriveQuantity::torso_bend, 1.5, 0.1, {DriveQuantity::head_bend}}});
  const auto bent = quantity_of(result, DriveQuantity::head_bend);
  for (size_t i = 0; i < torso.size(); ++i) {
    EXPECT_NEAR(bent[i], head[i] + drive.slope * (0.5 * torso[i] + 0.1), 1e-9) << i;
  }
}

TEST(Driven, OfNoAmountIsTheMotion) {
  const Clip motion = builtin_walk("happy").clip;
  const auto edits = drives_towards(builtin_walk("normal").clip, builtin_walk("sad").clip);
  EXPECT_LT(largest_difference(driven(motion, edits, {.amount = 0.0}), motion), 1e-9);
}

TEST(Driven, TowardsTheMotionItselfChangesNothing) {
  const Clip sad = builtin_walk("sad").clip;
  EXPECT_LT(largest_difference(driven(sad, drives_towards(sad, sad)), sad), 1e-6);
}

TEST(Driven, TowardsAStyleBendsMoreAndMore) {
  const Clip normal = builtin_walk("normal").clip;
  const Clip sad = builtin_walk("sad").clip;
  const auto mean = [](const Clip& clip, DriveQuantity quantity) {
    double sum = 0.0;
    for (const double value : quantity_of(clip, quantity)) sum += value / clip.frame_count();
    return sum;
  };
  double bent = -1.0;
  for (const double amount : {0.0, 0.5, 1.0, 1.5}) {
    const Clip result = driven(normal, drives_towards(normal, sad), {.amount = amount});
    EXPECT_GT(mean(result, DriveQuantity::head_bend), bent);
    bent = mean(result, DriveQuantity::head_bend);
    if (amount == 1.0) {
      EXPECT_NEAR(bent, mean(sad, DriveQuantity::head_bend), 0.02);
    }
  }
}

}  // namespace
}  // namespace mien::motion
