#include "render/geometry/box.h"

#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "render/geometry/embree_scene.h"

namespace mien::render {
namespace {

class Boxes : public testing::Test {
 protected:
  float uniform(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random_);
  }
  Vec3 place(float size) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }

  /// Eight rays from near or far towards somewhere in the box, some of them along the axes or with
  /// their origin in the box, that reach just beyond there.
  RayPacket rays_into(const Box& box) {
    RayPacket rays;
    for (int i = 0; i < packet_size; ++i) {
      const Vec3 share{uniform(0.0f, 1.0f), uniform(0.0f, 1.0f), uniform(0.0f, 1.0f)};
      const Vec3 target = box.lower.matrix() + share.cwiseProduct((box.upper - box.lower).matrix());
      Vec3 direction = place(1.0f);
      if (i % 3 == 1) direction[i % 2] = 0.0f;
      if (i % 4 == 3) direction = Vec3::Unit(i % 3);
      direction.normalize();
      const float distance = i == 5 ? 0.0f : uniform(0.0f, i % 2 == 0 ? 0.2f : 30.0f);
      rays.push(target - distance * direction, direction, distance * 1.001f + 1e-3f);
    }
    return rays;
  }

  static RayLanes lanes_of(const RayPacket& rays) {
    return {rays.origin_x,    rays.origin_y,    rays.origin_z,
            rays.direction_x, rays.direction_y, rays.direction_z};
  }

 private:
  std::mt19937 random_{5};
};

TEST_F(Boxes, AreFoundByAllRaysThatEnterThem) {
  for (int trial = 0; trial < 20000; ++trial) {
    const Vec3 lower = place(trial % 2 == 0 ? 1.0f : 50.0f);
    // Flat ones, too.
    const Vec3 size = (place(0.1f).array() + 0.1f).matrix();
    const Box box{lower.array(),
                  (lower + (trial % 5 == 0 ? Vec3(size.x(), 0.0f, 0.0f) : size)).array()};
    const RayPacket rays = rays_into(box);
    int may_hit[packet_size];
    find_rays_through(padded(box), lanes_of(rays), rays.reach, may_hit);
    for (int i = 0; i < packet_size; ++i) EXPECT_EQ(may_hit[i], -1) << trial << ", ray " << i;
  }
}

// By the three slabs, in double precision.
TEST_F(Boxes, AreFoundByNoOtherRays) {
  int beside = 0, behind = 0, out_of_reach = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    const Vec3 lower = place(1.0f);
    const Box box{lower.array(), lower.array() + 0.05f + place(0.04f).array()};
    const Box around{box.lower - 1e-3f, box.upper + 1e-3f};
    RayPacket rays;
    for (int i = 0; i < packet_size; ++i) {
      const Vec3 origin = place(2.0f);
      const Vec3 towards = lower + place(0.2f) - origin;
      rays.push(origin, (i == 7 ? -towards : towards).normalized(), uniform(0.1f, 5.0f));
    }
    int may_hit[packet_size];
    find_rays_through(padded(box), lanes_of(rays), rays.reach, may_hit);
    for (int i = 0; i < packet_size; ++i) {
      double enter = -std::numeric_limits<double>::infinity();
      double leave = std::numeric_limits<double>::infinity();
      for (int axis = 0; axis < 3; ++axis) {
        const double o = static_cast<double>(rays.origin(i)[axis]);
        const double d = static_cast<double>(rays.direction(i)[axis]);
        const double a = (static_cast<double>(around.lower[axis]) - o) / d;
        const double b = (static_cast<double>(around.upper[axis]) - o) / d;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
      }
      const bool misses = enter > leave, ends = enter > static_cast<double>(rays.reach[i]);
      if (!misses && leave >= 0.0 && !ends) continue;
      EXPECT_EQ(may_hit[i], 0) << trial << ", ray " << i;
      ++(misses ? beside : leave < 0.0 ? behind : out_of_reach);
    }
  }
  EXPECT_GT(beside, 10000);
  EXPECT_GT(behind, 100);
  EXPECT_GT(out_of_reach, 500);
}

}  // namespace
}  // namespace mien::render
