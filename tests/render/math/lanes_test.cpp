#include "render/math/lanes.h"

#include <random>

#include <gtest/gtest.h>

#include "render/light/light.h"
#include "render/light/one_by_one.h"
#include "render/light/sky_cone.h"
#include "render/math/constants.h"
#include "render/math/sampler.h"
#include "render/scene/camera.h"

namespace mien::render {
namespace {

constexpr int eight = static_cast<int>(lanes);

class Lanes : public testing::Test {
 protected:
  float uniform(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random_);
  }
  Vec3 direction() {
    const Vec3 v{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    return v.normalized();
  }
  LanePoints points() {
    LanePoints u;
    for (int i = 0; i < eight; ++i) {
      u.u[i] = uniform(0.0f, 0.9999f);
      u.v[i] = uniform(0.0f, 0.9999f);
    }
    return u;
  }

 private:
  std::mt19937 random_{3};
};

TEST_F(Lanes, GiveThePointsOfTheSampler) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    LaneWords index, seeds;
    for (int i = 0; i < eight; ++i) {
      index[i] = 37u * seed + static_cast<std::uint32_t>(i);
      seeds[i] = mixed(seed, static_cast<std::uint32_t>(i / 3));
    }
    const LanePoints found = sample_points(index, seeds);
    for (int i = 0; i < eight; ++i) {
      const Point2 expected = sample_point(index[i], seeds[i]);
      EXPECT_EQ(found.u[i], expected.u);
      EXPECT_EQ(found.v[i], expected.v);
    }
  }
}

TEST_F(Lanes, GiveTheDirectionsOfOneByOne) {
  for (int trial = 0; trial < 200; ++trial) {
    LaneVectors normals;
    for (int i = 0; i < eight; ++i) normals.set(i, direction());
    LanePoints u = points();
    if (trial == 0) u.u[0] = u.v[0] = 0.5f;  // the middle of the disc
    if (trial < 20) normals.set(1, -Vec3::UnitZ());
    const LaneVectors cosine = cosine_directions(normals, u);
    for (int i = 0; i < eight; ++i) {
      const Point2 point{u.u[i], u.v[i]};
      EXPECT_LT((cosine.at(i) - test::cosine_direction(normals.at(i), point)).norm(), 1e-6f);
    }
  }
}

TEST_F(Lanes, GiveThePointsOfALight) {
  const AreaLight light =
      softbox({1.0f, 4.0f, 2.0f}, Vec3::UnitY(), 1.5f, 0.7f, Color::Constant(3.0f));
  for (int trial = 0; trial < 200; ++trial) {
    LaneVectors places;
    for (int i = 0; i < eight; ++i) places.set(i, {uniform(-9, 9), uniform(-2, 9), uniform(-9, 9)});
    const LanePoints u = points();
    const LaneLights found = sample(light, places, u);
    for (int i = 0; i < eight; ++i) {
      const test::LightSample expected = test::sample(light, places.at(i), {u.u[i], u.v[i]});
      EXPECT_LT((found.towards.at(i) - expected.towards).norm(), 2e-6f);
      EXPECT_NEAR(found.distance[i], expected.distance, 1e-5f);
      EXPECT_NEAR(3.0f * found.share[i], expected.perpendicular.x(),
                  1e-4f * (1.0f + expected.perpendicular.x()));
    }
  }
}

TEST_F(Lanes, GiveTheRaysTowardsABall) {
  int within_a_cone = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 centre{uniform(-1, 1), uniform(0.1f, 2.0f), uniform(-1, 1)};
    const float radius = uniform(0.1f, 1.5f);
    LaneVectors places, normals;
    for (int i = 0; i < eight; ++i) {
      places.set(i, {uniform(-4, 4), 0.0f, uniform(-4, 4)});
      normals.set(i, trial % 2 == 0 ? Vec3(Vec3::UnitY()) : direction());
    }
    const LanePoints u = points();
    const LaneSphereRays found = rays_to_sphere(centre, radius, places, normals, u);
    for (int i = 0; i < eight; ++i) {
      const auto cone = cone_of({centre, radius}, places.at(i));
      within_a_cone += cone ? 1 : 0;
      const Point2 point{u.u[i], u.v[i]};
      const Vec3 towards = cone ? test::cone_direction(cone->axis, cone->cosine, point)
                                : test::cosine_direction(normals.at(i), point);
      EXPECT_LT((found.towards.at(i) - towards).norm(), 4e-6f);
      const float share = cone ? cone->solid_angle() / pi * towards.dot(normals.at(i)) : 1.0f;
      EXPECT_NEAR(found.share[i], share, 1e-5f);
    }
  }
  EXPECT_GT(within_a_cone, 100);
  EXPECT_LT(within_a_cone, 200 * eight - 20) << "both cases are tried";
}

TEST_F(Lanes, GiveTheRaysOfACamera) {
  for (const float height : {0.0f, 2.5f}) {
    const CameraFrame camera = frame_of({.position = {1.0f, 2.0f, 4.0f},
                                         .target = {0.2f, 1.0f, 0.1f},
                                         .parallel_height = height,
                                         .shift_x = 12.0f});
    LaneFloats x, y;
    for (int i = 0; i < eight; ++i) {
      x[i] = uniform(0.0f, 960.0f);
      y[i] = uniform(0.0f, 540.0f);
    }
    const LaneRays rays = camera_rays(camera, x, y);
    for (int i = 0; i < eight; ++i) {
      const CameraRay expected = camera.ray(x[i], y[i]);
      EXPECT_LT((rays.origin.at(i) - expected.origin).norm(), 1e-6f);
      EXPECT_LT((rays.direction.at(i) - expected.direction).norm(), 1e-6f);
    }
  }
}

TEST_F(Lanes, GiveTheLightOnTheFloorOfOneByOne) {
  int lit = 0, dark = 0;
  for (int trial = 0; trial < 500; ++trial) {
    // Some shine upwards, some reach below the floor.
    const Vec3 u = uniform(0.1f, 2.0f) * direction();
    const Vec3 v = uniform(0.1f, 2.0f) * u.cross(direction()).normalized();
    const AreaLight light{
        {uniform(-2, 2), uniform(-1, 4), uniform(-2, 2)}, u, v, Color::Constant(1.0f)};
    LaneVectors points;
    for (int i = 0; i < eight; ++i) points.set(i, {uniform(-5, 5), 0.0f, uniform(-5, 5)});
    const LaneFloats found = irradiance(FloorLight(light), points);
    for (int i = 0; i < eight; ++i) {
      const float expected = test::irradiance(light, points.at(i), Vec3::UnitY()).x();
      EXPECT_NEAR(found[i], expected, 2e-6f + 1e-5f * expected);
      ++(expected > 0.0f ? lit : dark);
    }
  }
  EXPECT_GT(lit, 500);
  EXPECT_GT(dark, 500);
}

// Where an edge of the light is far off, and where it is all but overhead.
TEST_F(Lanes, GiveTheLightOfEdgesSeenUnderAnyAngle) {
  for (int trial = 0; trial < 500; ++trial) {
    const float side = std::exp2(uniform(-4, 4)), height = std::exp2(uniform(-7, 4));
    const AreaLight light{
        {0.0f, height, 0.0f}, {side, 0.0f, 0.0f}, {0.0f, 0.0f, side}, Color::Constant(1.0f)};
    LaneVectors points;
    for (int i = 0; i < eight; ++i)
      points.set(i, {uniform(-2 * side, 2 * side), 0.0f, uniform(-2 * side, 2 * side)});
    const LaneFloats found = irradiance(FloorLight(light), points);
    for (int i = 0; i < eight; ++i) {
      const float expected = test::irradiance(light, points.at(i), Vec3::UnitY()).x();
      EXPECT_NEAR(found[i], expected, 5e-6f + 1e-5f * expected) << side << ' ' << height;
    }
  }
}

}  // namespace
}  // namespace mien::render
