#include "render/geometry/triangle.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace mien::render {
namespace {

float distance_to(const Triangle& triangle, const Vec3& origin, const Vec3& direction) {
  float found[patch_size];
  intersect_patch(patches_of({triangle})[0], origin, direction, found);
  return found[0];
}

class Triangles : public testing::Test {
 protected:
  float uniform(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random_);
  }
  Vec3 place(float size) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }

 private:
  std::mt19937 random_{11};
};

TEST_F(Triangles, AreHitWhereTheyAre) {
  for (int trial = 0; trial < 2000; ++trial) {
    const Triangle triangle{place(1.0f), place(1.0f), place(1.0f)};
    const float b = uniform(0.05f, 0.9f), c = uniform(0.0f, 0.95f - b);
    if (c < 0.02f) continue;
    const Vec3 point = (1.0f - b - c) * triangle.a + b * triangle.b + c * triangle.c;
    const Vec3 origin = point + 5.0f * place(1.0f);
    const Vec3 direction = (point - origin).normalized();
    const Vec3 normal = (triangle.b - triangle.a).cross(triangle.c - triangle.a).normalized();
    if (std::abs(normal.dot(direction)) < 0.05f) continue;
    EXPECT_NEAR(distance_to(triangle, origin, direction), (point - origin).norm(), 1e-3f);
    // Nothing behind, nothing beside.
    EXPECT_TRUE(std::isinf(distance_to(triangle, origin, -direction)));
    const Vec3 outside = triangle.a - 0.2f * (triangle.b - triangle.a);
    EXPECT_TRUE(std::isinf(distance_to(triangle, origin, (outside - origin).normalized())));
    const Barycentric found = barycentric(triangle, point);
    EXPECT_NEAR(found.b, b, 1e-3f);
    EXPECT_NEAR(found.c, c, 1e-3f);
  }
}

// Rays at points of a shared edge, which rounding puts on either side of it.
TEST_F(Triangles, LetNoRayThroughAnEdgeThatTheyShare) {
  for (int trial = 0; trial < 20000; ++trial) {
    const Vec3 a = place(0.05f), b = place(0.05f);
    const Vec3 left = place(1.0f), right = 0.5f * (a + b) - 0.7f * (left - 0.5f * (a + b));
    const Vec3 origin = 0.5f * (a + b) + 6.0f * place(1.0f);
    const Vec3 point = a + uniform(0.1f, 0.9f) * (b - a);
    const Vec3 direction = (point - origin).normalized();
    const bool hit = std::isfinite(distance_to({a, b, left}, origin, direction)) ||
                     std::isfinite(distance_to({b, a, right}, origin, direction));
    EXPECT_TRUE(hit) << "trial " << trial;
  }
}

}  // namespace
}  // namespace mien::render
