#include "render/geometry/shadow_mask.h"

#include <random>

#include <gtest/gtest.h>

namespace mien::render {
namespace {

// A ring of balls in whose middle the floor is lit.
Shapes ring() {
  Solids solids;
  for (int k = 0; k < 40; ++k) {
    const float angle = 0.157f * static_cast<float>(k);
    solids.spheres.push_back({{std::cos(angle), 0.3f, std::sin(angle)}, 0.1f});
  }
  Shapes shapes;
  shapes.cones = prepared_cones(solids);
  return shapes;
}

TEST(ShadowMask, KnowsAreasThatMayBeShadedAllOver) {
  const AreaLight light{{0.0f, 5.0f, 0.0f}, {0.1f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.1f}};
  const ShadowMask mask(light, ring());
  std::mt19937 random(2);
  std::uniform_real_distribution<float> place(-1.4f, 1.4f), size(0.0f, 0.3f), share(0.0f, 1.0f);
  int all = 0, some = 0, none = 0;
  for (int k = 0; k < 20'000; ++k) {
    const float x = place(random), z = place(random);
    const FloorArea area{x, x + size(random), z, z + size(random)};
    if (!mask.may_shade(area)) {
      EXPECT_FALSE(mask.may_shade_all(area));
      ++none;
      continue;
    }
    if (!mask.may_shade_all(area)) {
      ++some;
      continue;
    }
    ++all;
    for (int i = 0; i < 8; ++i) {
      const float within_x = area.x_min + share(random) * (area.x_max - area.x_min);
      const float within_z = area.z_min + share(random) * (area.z_max - area.z_min);
      EXPECT_TRUE(mask.may_shade({within_x, within_x, within_z, within_z}));
    }
  }
  EXPECT_GT(all, 500);
  EXPECT_GT(some, 500);
  EXPECT_GT(none, 500);
}

}  // namespace
}  // namespace mien::render
