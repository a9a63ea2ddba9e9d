#include "render/geometry/bounding_volumes.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace mien::render {
namespace {

TEST(MayMeet, HoldsForEveryRayTowardsAPointInTheSphere) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> share(-1.0f, 1.0f);
  const auto point = [&](float reach) {
    return Vec3(reach * share(random), reach * share(random), reach * share(random));
  };
  int missed = 0;
  for (int i = 0; i < 100'000; ++i) {
    const float reach = std::exp2(7.0f * share(random));  // 8 mm … 128 m
    const BoundingSphere sphere{point(5.0f), std::exp2(4.0f * share(random))};
    Vec3 within = point(1.0f);
    if (within.norm() > 1.0f) within.normalize();  // often at the very rim
    const Vec3 origin = point(reach);
    const Vec3 target = sphere.centre + sphere.radius * within;
    EXPECT_TRUE(may_intersect(sphere, origin, (target - origin).normalized()));
    missed += may_intersect(sphere, origin, point(1.0f).normalized()) ? 0 : 1;
  }
  EXPECT_GT(missed, 20'000);  // it does rule rays out
}

TEST(PixelMask, KnowsOfStretchesOfARowWhatItKnowsOfTheirPixels) {
  Solids solids;
  solids.spheres = {{{-0.5f, 1.0f, 0.0f}, 0.1f}, {{0.6f, 1.1f, 0.0f}, 0.15f}};
  Shapes shapes;
  shapes.cones = prepared_cones(solids);
  const Camera camera{.width = 64, .height = 48};
  const PixelMask mask(camera, shapes, 1.0f);
  int met = 0, between = 0;
  for (int y = 0; y < camera.height; ++y) {
    for (int begin = 0; begin < camera.width; ++begin) {
      bool any = false;
      for (int end = begin + 1; end <= camera.width; ++end) {
        any |= mask.may_intersect(end - 1, y);
        EXPECT_EQ(mask.may_intersect_row(begin, end, y), any) << begin << " … " << end << ", " << y;
        met += any ? 1 : 0;
        between += !any && mask.may_intersect_row(0, begin, y) && mask.may_intersect_row(end, 64, y)
                       ? 1
                       : 0;
      }
    }
  }
  EXPECT_GT(met, 1000);
  EXPECT_GT(between, 300);
}

TEST(MayMeet, IsFalseWithoutAFigure) {
  EXPECT_FALSE(may_intersect({}, {0.0f, 1.0f, 2.0f}, {0.0f, 0.0f, -1.0f}));
}

}  // namespace
}  // namespace mien::render
