#include "motion/biomechanics/collision_shapes.h"

#include <gtest/gtest.h>

#include "motion/lint/injected_faults.h"

namespace mien::motion {
namespace {

using namespace mien::test;

double sampled_distance(const RoundCone& a, const RoundCone& b) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 200; ++i) {
    for (int k = 0; k <= 200; ++k) {
      const Vec3 p = a.from + i / 200.0 * (a.to - a.from);
      const Vec3 q = b.from + k / 200.0 * (b.to - b.from);
      least = std::min(least, (p - q).norm());
    }
  }
  return least;
}

TEST(CollisionShapes, DepthIsWhatRadiiOverlap) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  const auto point = [&] { return Vec3(place(random), place(random), place(random)); };
  for (int i = 0; i < 40; ++i) {
    const RoundCone a = {point(), point(), 0.1, 0.1};
    const RoundCone b = {point(), point(), 0.2, 0.2};
    EXPECT_NEAR(penetration_depth(a, b), 0.3 - sampled_distance(a, b),
                2e-2 * (a.to - a.from).norm());
    EXPECT_NEAR(penetration_depth(a, b), penetration_depth(b, a), 1e-9);
  }
}

TEST(CollisionShapes, DepthOfPointsAndParallelsIsKnown) {
  const RoundCone point = {Vec3(0, 0, 0), Vec3(0, 0, 0), 0.5, 0.5};
  const RoundCone bar = {Vec3(-1, 0.7, 0), Vec3(1, 0.7, 0), 0.4, 0.4};
  EXPECT_NEAR(penetration_depth(point, bar), 0.2, 1e-12);
  EXPECT_NEAR(penetration_depth(bar, point), 0.2, 1e-12);
  const RoundCone beside = {Vec3(-1, 0.0, 0), Vec3(1, 0.0, 0), 0.1, 0.1};
  EXPECT_NEAR(penetration_depth(bar, beside), -0.2, 1e-12);
  // A cone is thicker where its thick end is.
  const RoundCone cone = {Vec3(0, 1, 0), Vec3(0, 3, 0), 0.3, 0.1};
  EXPECT_NEAR(penetration_depth(cone, point), -0.2, 1e-12);
}

TEST(CollisionShapes, OfJoinedPartsAreNotCompared) {
  for (const CollisionPair& pair : collision_pairs(standard_body())) {
    const BodyJoint a = collision_parts()[pair.a].joint;
    const BodyJoint b = collision_parts()[pair.b].joint;
    EXPECT_NE(body_parents[a], b);
    EXPECT_NE(body_parents[b], a);
    EXPECT_LT(pair.allowed, 0.06) << collision_parts()[pair.a].name << " "
                                  << collision_parts()[pair.b].name;
  }
}

TEST(SelfIntersection, OfOneLegInTheOtherIsAnError) {
  Clip clip = three_cycles(builtin_walks()[0]);
  for (int t = 30; t < 50; ++t) {
    // The left leg takes the place of the right one.
    for (int j = LeftHip; j <= LeftToe; ++j) {
      clip.poses[t].rotations[j] = clip.poses[t].rotations[j + (RightHip - LeftHip)];
    }
    clip.poses[t].rotations[LeftHip] = exp(Vec3(0, 0, -0.22)) * clip.poses[t].rotations[LeftHip];
  }
  EXPECT_TRUE(find_error(lint(clip), "self-intersection", "Knee", 30, 50)) << all_of(lint(clip));
}

TEST(SelfIntersection, ThatTheOriginalHadTooIsNone) {
  Clip clip = three_cycles(builtin_walks()[0]);
  put_hand_through_torso(clip, true, 20, 45);
  EXPECT_TRUE(find(lint(clip), "self-intersection"));
  EXPECT_FALSE(find(lint(clip, {}, &clip), "self-intersection"));
}

}  // namespace
}  // namespace mien::motion
