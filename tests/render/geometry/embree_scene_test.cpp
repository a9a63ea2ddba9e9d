#include "render/geometry/embree_scene.h"

#include <array>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace mien::render {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// One ray of a packet.
struct OneRay {
  Vec3 origin;
  Vec3 direction;
  float time = 0.0f;
  std::uint32_t present = ~0u;

  RayLanes lanes() const {
    return {&origin.x(), &origin.y(), &origin.z(), &direction.x(), &direction.y(), &direction.z()};
  }
};

/// Distance at which a ray hits a shape, by its own test; infinity if it misses.
float distance_to(const Shapes& shapes, std::size_t shape, const OneRay& ray) {
  if (!shapes.all_present && ((ray.present >> shapes.figures[shape]) & 1u) == 0) return infinity;
  if (shape < shapes.cones.size()) {
    float enter = 0.0f, leave = 0.0f, found = infinity;
    const float from = 0.0f;
    intersect_lines(shapes.cone_at(shape, ray.time), ray.lanes(), 1, &enter, &leave);
    crossings_beyond(&from, &enter, &leave, 1, &found);
    return found;
  }
  float found[patch_size];
  const Triangle triangle = shapes.triangle_at(shape - shapes.cones.size(), ray.time);
  intersect_patch(prepared_patch(corners_of({triangle})[0]), ray.lanes(), 0, found);
  return found[0];
}

/// Triangles and round cones of three figures. Their number of triangles is no multiple of a
/// patch's, and some are there twice.
class EmbreeScenes : public testing::TestWithParam<bool> {
 protected:
  float uniform(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random_);
  }
  Vec3 place(float size) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }

  Shapes any_shapes(bool moves) {
    Shapes shapes;
    Solids solids, closing;
    for (int i = 0; i < 3; ++i) {
      RoundCone cone{place(1.0f), place(1.0f), uniform(0.05f, 0.3f), uniform(0.05f, 0.3f)};
      solids.round_cones.push_back(cone);
      cone.end += place(0.3f);
      closing.round_cones.push_back(cone);
    }
    shapes.cones = prepared_cones(solids);
    for (int i = 0; i < 27; ++i) {
      if (i % 9 == 8) {
        shapes.triangles.push_back(shapes.triangles.front());
        if (moves) shapes.closing_triangles.push_back(shapes.closing_triangles.front());
        continue;
      }
      const Vec3 corner = place(1.0f);
      const Triangle triangle{corner, corner + place(0.5f), corner + place(0.5f)};
      shapes.triangles.push_back(triangle);
      const Vec3 step = place(0.3f);
      if (moves)
        shapes.closing_triangles.push_back(
            {triangle.a + step, triangle.b + step, triangle.c - step});
    }
    if (moves) shapes.closing_cones = prepared_cones(closing);
    for (std::size_t i = 0; i < shapes.cones.size() + shapes.triangles.size(); ++i)
      shapes.figures.push_back(static_cast<std::uint8_t>(i % 3));
    shapes.all_present = false;
    return shapes;
  }

 private:
  std::mt19937 random_{3};
};

TEST_P(EmbreeScenes, FindWhatTestingEveryShapeFinds) {
  const EmbreeDevice device("");
  int hits = 0, misses = 0, of_triangles = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Shapes shapes = any_shapes(GetParam());
    const EmbreeScene scene(device, shapes);
    for (int packet = 0; packet < 20; ++packet) {
      RayPacket rays;
      std::array<OneRay, packet_size> single;
      const int count = 1 + packet % packet_size;
      for (int i = 0; i < count; ++i) {
        OneRay& ray = single[static_cast<std::size_t>(i)];
        ray.origin = 3.0f * place(1.0f);
        ray.direction = (place(1.0f) - ray.origin).normalized();
        ray.time = i % 4 == 3 ? 1.0f : GetParam() ? uniform(0.0f, 1.0f) : 0.0f;
        ray.present = trial % 2 == 0 ? ~0u : 0b101u;
        rays.push(ray.origin, ray.direction, uniform(0.5f, 8.0f), ray.time, ray.present);
      }
      const Hits found = scene.intersect(rays);
      const std::uint32_t occluded = scene.occluded(rays);
      for (int i = 0; i < count; ++i) {
        const float reach = rays.reach[i];
        float nearest = infinity;
        int shape = -1;
        for (std::size_t k = 0; k < shapes.cones.size() + shapes.triangles.size(); ++k) {
          const float distance = distance_to(shapes, k, single[static_cast<std::size_t>(i)]);
          if (distance >= nearest || distance >= reach) continue;
          nearest = distance;
          shape = static_cast<int>(k);
        }
        EXPECT_EQ(found.shape[i], shape) << "trial " << trial << ", ray " << i;
        if (shape >= 0) {
          EXPECT_EQ(found.distance[i], nearest);
        }
        EXPECT_EQ(((occluded >> i) & 1u) != 0, shape >= 0);
        ++(shape >= 0 ? hits : misses);
        of_triangles += shape >= static_cast<int>(shapes.cones.size()) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(hits, 500);
  EXPECT_GT(misses, 500);
  EXPECT_GT(of_triangles, 200);
}

INSTANTIATE_TEST_SUITE_P(Shapes, EmbreeScenes, testing::Bool(),
                         [](const auto& tested) { return tested.param ? "that_move" : "at_rest"; });

}  // namespace
}  // namespace mien::render
