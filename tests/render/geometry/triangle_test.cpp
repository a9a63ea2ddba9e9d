#include "render/geometry/triangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace mien::render {
namespace {

float distance_to(const Triangle& triangle, const Vec3& origin, const Vec3& direction) {
  const RayLanes ray{&origin.x(),    &origin.y(),    &origin.z(),
                     &direction.x(), &direction.y(), &direction.z()};
  float found[patch_size];
  intersect_patch(prepared_patch(corners_of({triangle})[0]), ray, 0, found);
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

/// A ray of random origin and direction towards the middle.
struct Ray {
  Vec3 origin;
  Vec3 direction;

  RayLanes lanes() const {
    return {&origin.x(), &origin.y(), &origin.z(), &direction.x(), &direction.y(), &direction.z()};
  }
};

// Möller and Trumbore's test, in double precision, away from edges, where rounding may differ.
TEST_F(Triangles, AreHitInPatchesAsOneByOne) {
  int hits = 0, misses = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<Triangle> triangles;
    for (int i = 0; i < 11; ++i) triangles.push_back({place(1.0f), place(1.0f), place(1.0f)});
    const std::vector<PatchCorners> patches = corners_of(triangles);
    ASSERT_EQ(patches.size(), 2u);
    Ray ray{4.0f * place(1.0f), Vec3::Zero()};
    ray.direction = (place(0.5f) - ray.origin).normalized();
    for (std::size_t patch = 0; patch < 2; ++patch) {
      float found[patch_size];
      const float nearest = intersect_patch(prepared_patch(patches[patch]), ray.lanes(), 0, found);
      EXPECT_EQ(nearest, *std::min_element(found, found + patch_size));
      for (std::size_t k = 0; k < patch_size; ++k) {
        const std::size_t number = patch * patch_size + k;
        if (number >= triangles.size()) {
          EXPECT_TRUE(std::isinf(found[k])) << "an unused lane";
          continue;
        }
        const Eigen::Vector3d a = triangles[number].a.cast<double>();
        const Eigen::Vector3d ab = triangles[number].b.cast<double>() - a;
        const Eigen::Vector3d ac = triangles[number].c.cast<double>() - a;
        const Eigen::Vector3d d = ray.direction.cast<double>();
        const Eigen::Vector3d from = ray.origin.cast<double>() - a;
        const double volume = ab.dot(d.cross(ac));
        const double b = from.dot(d.cross(ac)) / volume, c = d.dot(from.cross(ab)) / volume;
        const double t = ac.dot(from.cross(ab)) / volume;
        const double inside = std::min({b, c, 1.0 - b - c});
        if (std::abs(inside) < 1e-3 || std::abs(t) < 1e-3 || std::abs(volume) < 1e-2) continue;
        const bool is_hit = inside > 0.0 && t > 0.0;
        EXPECT_EQ(std::isfinite(found[k]), is_hit) << "trial " << trial << ", triangle " << number;
        if (is_hit) {
          EXPECT_NEAR(found[k], t, 1e-3 * (1.0 + t));
        }
        ++(is_hit ? hits : misses);
      }
    }
  }
  EXPECT_GT(hits, 500);
  EXPECT_GT(misses, 5000);
}

TEST_F(Triangles, AreHitWhereTheyHaveMoved) {
  int hits = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    std::vector<Triangle> from, to, moved;
    const float time = uniform(0.0f, 1.0f);
    for (std::size_t i = 0; i < patch_size; ++i) {
      from.push_back({place(1.0f), place(1.0f), place(1.0f)});
      const Vec3 path = place(1.0f);
      to.push_back({from[i].a + path, from[i].b + path, from[i].c + 2.0f * path});
      const Triangle &a = from.back(), &b = to.back();
      moved.push_back(
          {a.a + time * (b.a - a.a), a.b + time * (b.b - a.b), a.c + time * (b.c - a.c)});
    }
    Ray ray{4.0f * place(1.0f), Vec3::Zero()};
    ray.direction = (place(0.5f) - ray.origin).normalized();
    float found[patch_size], expected[patch_size];
    const float nearest =
        intersect_moving_patch(corners_of(from)[0], corners_of(to)[0], time, ray.lanes(), 0, found);
    EXPECT_EQ(nearest,
              intersect_patch(prepared_patch(corners_of(moved)[0]), ray.lanes(), 0, expected));
    for (std::size_t k = 0; k < patch_size; ++k) EXPECT_EQ(found[k], expected[k]);
    hits += std::isfinite(nearest) ? 1 : 0;
  }
  EXPECT_GT(hits, 300);
}

TEST_F(Triangles, OccludeRaysThatTheyHitWithinReach) {
  int blocked = 0, out_of_reach = 0, missed = 0;
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<Triangle> triangles;
    for (int i = 0; i < 5; ++i) triangles.push_back({place(1.0f), place(1.0f), place(1.0f)});
    const TrianglePatch patch = prepared_patch(corners_of(triangles)[0]);
    float origins[3][max_lanes], directions[3][max_lanes], reach[max_lanes], before[max_lanes];
    int valid[max_lanes];
    const RayLanes rays{origins[0],    origins[1],    origins[2],
                        directions[0], directions[1], directions[2]};
    for (unsigned i = 0; i < max_lanes; ++i) {
      const Vec3 origin = 4.0f * place(1.0f), direction = (place(0.5f) - origin).normalized();
      for (int axis = 0; axis < 3; ++axis) {
        origins[axis][i] = origin[axis];
        directions[axis][i] = direction[axis];
      }
      before[i] = reach[i] = uniform(0.0f, 8.0f);
      valid[i] = i % 5 == 4 ? 0 : -1;
    }
    occlude_by_patch(patch, rays, valid, max_lanes, reach);
    for (unsigned i = 0; i < max_lanes; ++i) {
      float found[patch_size];
      const float nearest = intersect_patch(patch, rays, i, found);
      const bool is_blocked = valid[i] != 0 && nearest < before[i];
      EXPECT_EQ(reach[i], is_blocked ? -std::numeric_limits<float>::infinity() : before[i]);
      if (valid[i] == 0) continue;
      ++(is_blocked ? blocked : std::isfinite(nearest) ? out_of_reach : missed);
    }
  }
  EXPECT_GT(blocked, 200);
  EXPECT_GT(out_of_reach, 200);
  EXPECT_GT(missed, 200);
}

}  // namespace
}  // namespace mien::render
