#include "motion/skeleton/two_bone_ik.h"

#include <random>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

Vec3 random_vector(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return {normal(random), normal(random), normal(random)};
}

TEST(TwoBoneIk, ReachesEveryTargetWithinReachAndKeepsBoneLengths) {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> extension(0.3, 0.99);
  for (int i = 0; i < 1000; ++i) {
    TwoBoneLimb limb;
    limb.root = random_vector(random);
    limb.middle = limb.root + 0.43 * random_vector(random).normalized();
    limb.end = limb.middle + 0.42 * random_vector(random).normalized();
    const Vec3 target = limb.root + 0.85 * extension(random) * random_vector(random).normalized();
    const TwoBoneSolution solution = solve_two_bone(limb, target, Vec3::UnitZ());
    const Vec3 middle = limb.root + solution.upper_turn * (limb.middle - limb.root);
    const Vec3 end = middle + solution.lower_turn * (limb.end - limb.middle);
    EXPECT_LT((end - target).norm(), 1e-9);
    EXPECT_LT((middle - solution.middle).norm(), 1e-9);
  }
}

TEST(TwoBoneIk, LeavesABentLimbThatIsAlreadyThereAlone) {
  std::mt19937_64 random(22);
  for (int i = 0; i < 200; ++i) {
    TwoBoneLimb limb{random_vector(random), random_vector(random), random_vector(random)};
    const Vec3 line = (limb.end - limb.root).normalized();
    const Vec3 upper = (limb.middle - limb.root).normalized();
    if (line.cross(upper).norm() < 0.1) continue;
    const TwoBoneSolution solution = solve_two_bone(limb, limb.end, Vec3::UnitZ());
    EXPECT_LT((solution.middle - limb.middle).norm(), 1e-7);
    EXPECT_LT(solution.upper_turn.angularDistance(Quat::Identity()), 1e-6);
  }
}

TEST(TwoBoneIk, StraightensTowardsATargetOutOfReach) {
  const TwoBoneLimb leg{{0, 1, 0}, {0, 0.6, 0.05}, {0, 0.2, 0}};
  const TwoBoneSolution solution = solve_two_bone(leg, {0, -3, 0}, Vec3::UnitZ(), 0.98);
  const double whole = (leg.middle - leg.root).norm() + (leg.end - leg.middle).norm();
  EXPECT_NEAR((solution.end - leg.root).norm(), 0.98 * whole, 1e-12);
  EXPECT_GT(solution.middle.z(), 0.0);
}

TEST(TwoBoneIk, StraightLimbBendsTowardsTheHint) {
  const TwoBoneLimb leg{{0, 1, 0}, {0, 0.5, 0}, {0, 0, 0}};
  const TwoBoneSolution solution = solve_two_bone(leg, {0, 0.3, 0}, Vec3::UnitZ());
  EXPECT_GT(solution.middle.z(), 0.1);
  EXPECT_NEAR(solution.middle.x(), 0.0, 1e-12);
}

TEST(TwoBoneIk, NoiseOfANearlyStraightLimbDoesNotTurnItsBend) {
  std::mt19937_64 random(23);
  std::normal_distribution<double> noise(0.0, 0.002);
  for (int i = 0; i < 500; ++i) {
    const TwoBoneLimb leg{{0, 1, 0}, {noise(random), 0.5, noise(random)}, {0, 0, 0}};
    const TwoBoneSolution solution = solve_two_bone(leg, {0, 0.02, 0}, Vec3::UnitZ());
    EXPECT_GT(solution.middle.z(), 0.09);
    EXPECT_LT(std::abs(solution.middle.x()), 0.03);
    // Nor does the bone turn about itself.
    EXPECT_LT(solution.upper_turn.angularDistance(Quat::Identity()), 0.35);
  }
}

TEST(TwoBoneIk, KeepsTheBendOfALimbThatIsClearlyBent) {
  const TwoBoneLimb leg{{0, 1, 0}, {0.06, 0.52, 0.0}, {0, 0.04, 0}};
  const TwoBoneSolution solution = solve_two_bone(leg, {0, 0.1, 0}, Vec3::UnitZ());
  EXPECT_GT(solution.middle.x(), 0.1);
  EXPECT_NEAR(solution.middle.z(), 0.0, 1e-9);
}

}  // namespace
}  // namespace mien::motion
