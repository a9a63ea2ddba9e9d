#include "render/math/directions.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "render/light/one_by_one.h"
#include "render/math/lanes.h"
#include "render/sample_mean.h"

namespace mien::render {
namespace {

Vec3 random_direction(std::mt19937& random) {
  std::normal_distribution<float> normal;
  return Vec3{normal(random), normal(random), normal(random)}.normalized();
}

TEST(ArcSine, IsThatOfTheLibrary) {
  for (int i = 0; i <= 1000; ++i) {
    const float x = static_cast<float>(i) / 1000.0f;
    EXPECT_NEAR(arc_sine(x), std::asin(static_cast<double>(x)), 3e-7) << x;
  }
}

// Concentric squares become concentric circles (Shirley & Chiu 1997).
TEST(DiscPoint, IsThatOfTheConcentricMapping) {
  for (int i = 0; i <= 40; ++i) {
    for (int j = 0; j <= 40; ++j) {
      const double x = i / 20.0 - 1.0, y = j / 20.0 - 1.0;
      const double radius = std::abs(x) > std::abs(y) ? x : y;
      double angle = 0.0;
      if (std::abs(x) > std::abs(y))
        angle = std::numbers::pi / 4.0 * y / x;
      else if (y != 0.0)
        angle = std::numbers::pi / 2.0 - std::numbers::pi / 4.0 * x / y;
      const DiscPoint found =
          disc_point({static_cast<float>(i) / 40.0f, static_cast<float>(j) / 40.0f});
      EXPECT_NEAR(found.x, radius * std::cos(angle), 2e-7) << x << ' ' << y;
      EXPECT_NEAR(found.y, radius * std::sin(angle), 2e-7) << x << ' ' << y;
    }
  }
}

// Moments of a density cos θ / π: E[cos θ] = 2/3, E[cos² θ] = 1/2; evenly round the normal.
TEST(CosineDirections, HaveTheMomentsOfACosine) {
  std::mt19937 random(2);
  const Vec3 normal = random_direction(random), across = normal.unitOrthogonal();
  test::SampleMean first, second, aside;
  for (std::uint32_t seed = 0; seed < 40000; ++seed) {
    const Vec3 towards =
        cosine_directions(test::in_all_lanes(normal), test::in_all_lanes(sample_point(0, seed)))
            .at(static_cast<int>(seed % lanes));
    EXPECT_NEAR(towards.norm(), 1.0f, 1e-5f);
    const auto cosine = static_cast<double>(towards.dot(normal));
    first.add(cosine);
    second.add(cosine * cosine);
    aside.add(static_cast<double>(towards.dot(across)));
  }
  test::expect_mean(first, 2.0 / 3.0, 0.002, 1e-6);
  test::expect_mean(second, 0.5, 0.002, 1e-6);
  test::expect_mean(aside, 0.0, 0.004, 1e-6);
}

// An even density on a cap has an even cos θ: mean (1 + c)/2, E[cos² θ] = (1 + c + c²)/3. The
// shares have the sphere's form factor as their mean: sin² θ, of a sphere straight above.
TEST(RaysToSphere, AreEvenOverItsCap) {
  for (const float least : {0.7f, 0.9f, 0.995f}) {
    const double c = static_cast<double>(least);
    const float radius = std::sqrt(1.0f - least * least);
    test::SampleMean first, second, share;
    for (std::uint32_t seed = 0; seed < 40000; ++seed) {
      const auto lane = static_cast<int>(seed % lanes);
      const LaneSphereRays rays = rays_to_sphere(
          {2.0f, 0.0f, 0.0f}, 2.0f * radius, test::in_all_lanes(Vec3::Zero()),
          test::in_all_lanes(Vec3::UnitX()), test::in_all_lanes(sample_point(0, seed)));
      const Vec3 towards = rays.towards.at(lane);
      EXPECT_GE(towards.x(), least - 1e-5f);
      first.add(static_cast<double>(towards.x()));
      second.add(static_cast<double>(towards.x() * towards.x()));
      share.add(static_cast<double>(rays.share[lane]));
    }
    test::expect_mean(first, 0.5 * (1.0 + c), 0.002 * (1.0 - c), 1e-6);
    test::expect_mean(second, (1.0 + c + c * c) / 3.0, 0.004 * (1.0 - c), 1e-6);
    test::expect_mean(share, 1.0 - c * c, 0.002 * (1.0 - c), 1e-6);
  }
}

}  // namespace
}  // namespace mien::render
