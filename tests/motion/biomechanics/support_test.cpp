#include "motion/biomechanics/support.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

TEST(Support, DistanceOutsideIsToTheHull) {
  const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}, {0.5, 0, 0.5}};
  EXPECT_NEAR(signed_distance_to_hull(Vec3(0.5, 3, 0.4), square), -0.4, 1e-12);
  EXPECT_NEAR(signed_distance_to_hull(Vec3(1.25, 0, 0.5), square), 0.25, 1e-12);
  EXPECT_NEAR(signed_distance_to_hull(Vec3(2, 0, 2), square), std::sqrt(2.0), 1e-12);
  EXPECT_TRUE(nearest_in_hull(Vec3(2, 5, 2), square).isApprox(Vec3(1, 0, 1)));
  EXPECT_TRUE(nearest_in_hull(Vec3(0.3, 5, 0.7), square).isApprox(Vec3(0.3, 0, 0.7)));
  EXPECT_NEAR(signed_distance_to_hull(Vec3(3, 0, 4), {Vec3::Zero()}), 5.0, 1e-12);
}

}  // namespace
}  // namespace mien::motion
