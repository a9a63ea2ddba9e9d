#include "render/geometry/shadow_mask.h"

#include <random>

#include <gtest/gtest.h>

namespace mien::render {
namespace {

// Points of the floor, capsules and lights of any place, size and direction.
TEST(ShadowMask, MissesNoPointFromWhichALightIsOccluded) {
  std::mt19937 random(5);
  const auto uniform = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  const auto place = [&](float size) {
    return Vec3(uniform(-size, size), uniform(-size, size), uniform(-size, size));
  };
  int shaded = 0, culled = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const AreaLight light{Vec3(0.0f, 5.0f, 0.0f) + place(3.0f), place(1.0f), place(1.0f)};
    Solids solids;
    for (int k = 0; k < 5; ++k) {
      RoundCone cone{place(1.0f), place(1.0f), uniform(0.01f, 0.1f), uniform(0.01f, 0.1f)};
      for (Vec3* end : {&cone.start, &cone.end}) end->y() += 1.2f;
      solids.round_cones.push_back(cone);
    }
    Shapes shapes;
    shapes.cones = prepared_cones(solids);
    const ShadowMask mask(light, shapes);
    const Vec3 front = light.half_u.cross(light.half_v);
    for (int k = 0; k < 200; ++k) {
      const Vec3 point(uniform(-3.0f, 3.0f), 0.0f, uniform(-3.0f, 3.0f));
      const Vec3 lamp =
          light.centre + uniform(-1.0f, 1.0f) * light.half_u + uniform(-1.0f, 1.0f) * light.half_v;
      const Vec3 towards = (lamp - point).normalized();
      if (lamp.y() <= 0.0f || front.dot(towards) >= 0.0f) continue;
      const FloorArea area{point.x(), point.x(), point.z(), point.z()};
      bool occluded = false;
      for (std::size_t i = 0; i < shapes.cones.size(); ++i) {
        float enter = 0.0f, leave = 0.0f;
        intersect_lines(
            shapes.cones[i],
            {&point.x(), &point.y(), &point.z(), &towards.x(), &towards.y(), &towards.z()}, 1,
            &enter, &leave);
        occluded |= enter < leave && enter > 0.0f && enter < (lamp - point).norm();
      }
      if (occluded) {
        EXPECT_TRUE(mask.may_shade(area)) << "trial " << trial;
      }
      shaded += occluded ? 1 : 0;
      culled += mask.may_shade(area) ? 0 : 1;
    }
  }
  EXPECT_GT(shaded, 500);
  EXPECT_GT(culled, 500);
}

}  // namespace
}  // namespace mien::render
