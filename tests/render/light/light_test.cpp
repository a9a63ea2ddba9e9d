#include "render/light/light.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "render/light/one_by_one.h"
#include "render/sample_mean.h"

namespace mien::render {
namespace {

/// From an element to a parallel rectangle a × b at distance c with a corner right above it
/// (Howell, catalogue of configuration factors, B-3).
double corner_factor(double a, double b, double c) {
  const double x = a / c, y = b / c;
  const double p = std::sqrt(1.0 + x * x), q = std::sqrt(1.0 + y * y);
  return (x / p * std::atan(y / p) + y / q * std::atan(x / q)) / (2.0 * std::numbers::pi);
}

/// Irradiance by the midpoint rule over the light.
double integrated(const AreaLight& light, const Vec3& point, const Vec3& normal) {
  constexpr int n = 400;
  const Eigen::Vector3d u = light.half_u.cast<double>(), v = light.half_v.cast<double>();
  const Eigen::Vector3d front = u.cross(v).normalized();
  const double cell = 4.0 * u.norm() * v.norm() / (n * n);
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Eigen::Vector3d span = light.centre.cast<double>() + ((2 * i + 1.0) / n - 1.0) * u +
                                   ((2 * j + 1.0) / n - 1.0) * v - point.cast<double>();
      const double squared = span.squaredNorm();
      const double in = span.dot(normal.cast<double>()), out = -span.dot(front);
      if (in > 0.0 && out > 0.0) sum += cell * in * out / (squared * squared);
    }
  }
  return sum * static_cast<double>(light.radiance.x());
}

AreaLight facing_down(const Vec3& centre, float half_x, float half_z) {
  // Emits towards cross(half_u, half_v) = −y.
  return {centre, {half_x, 0.0f, 0.0f}, {0.0f, 0.0f, half_z}, {10.0f, 20.0f, 40.0f}};
}

/// Irradiance at the origin of the floor from a light of radiance 1.
float on_floor(const AreaLight& light) {
  return irradiance(FloorLight(light), test::in_all_lanes(Vec3::Zero()))[3];
}

TEST(Irradiance, UnderAParallelRectangleIsTheFormFactor) {
  for (const float height : {0.5f, 2.0f, 4.0f}) {
    const AreaLight light = facing_down({0.0f, height, 0.0f}, 0.6f, 1.1f);
    const double expected = 10.0 * std::numbers::pi * 4.0 * corner_factor(0.6, 1.1, height);
    EXPECT_NEAR(10.0f * on_floor(light), expected, 1e-5 * expected);
  }
}

TEST(Irradiance, FromAnyRectangleIsItsIntegral) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> any(-1.0f, 1.0f);
  const auto direction = [&] { return Vec3{any(random), any(random), any(random)}.normalized(); };
  int seen = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const AreaLight light = softbox(3.0f * direction(), 0.5f * direction(), 1.0f + any(random) / 2,
                                    1.0f, Color::Constant(2.0f));
    // Many a light is cut by the horizon.
    const double expected = integrated(light, Vec3::Zero(), Vec3::UnitY());
    const auto found = 2.0 * static_cast<double>(on_floor(light));
    EXPECT_NEAR(found, expected, 1e-4 * expected + 1e-5) << "trial " << trial;
    seen += expected > 0.0;
  }
  EXPECT_GT(seen, 10);
}

TEST(Irradiance, BehindARectangleIsNone) {
  AreaLight light = facing_down({0.0f, 1.0f, 0.0f}, 0.5f, 0.5f);
  EXPECT_GT(on_floor(light), 0.0f);
  std::swap(light.half_u, light.half_v);  // faces up
  EXPECT_EQ(on_floor(light), 0.0f);
  EXPECT_EQ(sample(light, test::in_all_lanes(Vec3::Zero()), test::in_all_lanes(Point2{0.3f, 0.3f}))
                .share[0],
            0.0f);
}

TEST(LightSample, HasTheIrradianceAsItsMean) {
  const AreaLight light =
      softbox({1.5f, 1.0f, 0.3f}, {0.2f, 0.0f, 0.0f}, 1.2f, 0.7f, Color::Constant(5.0f));
  const double expected = static_cast<double>(on_floor(light));
  test::SampleMean estimates;
  for (std::uint32_t seed = 0; seed < 40000; ++seed) {
    const LaneLights s =
        sample(light, test::in_all_lanes(Vec3::Zero()), test::in_all_lanes(sample_point(0, seed)));
    estimates.add(static_cast<double>(s.share[5] * std::max(s.towards.y[5], 0.0f)));
  }
  test::expect_mean(estimates, expected, 0.003 * expected, 1e-5 * expected);
}

}  // namespace
}  // namespace mien::render
