#include "render/math/directions.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

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

TEST(Tangents, CompleteARightHandedFrame) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 500; ++trial) {
    const Vec3 normal = trial == 0 ? Vec3(-Vec3::UnitZ()) : random_direction(random);
    const Tangents frame = tangents(normal);
    EXPECT_LT((frame.a.cross(frame.b) - normal).norm(), 1e-5f);
    EXPECT_NEAR(frame.a.norm(), 1.0f, 1e-5f);
    EXPECT_NEAR(frame.a.dot(frame.b), 0.0f, 1e-5f);
  }
}

// Moments of a density cos θ / π: E[cos θ] = 2/3, E[cos² θ] = 1/2; evenly round the normal.
TEST(CosineDirection, HasTheMomentsOfACosine) {
  std::mt19937 random(2);
  const Vec3 normal = random_direction(random);
  const Tangents frame = tangents(normal);
  test::SampleMean first, second, across;
  for (std::uint32_t seed = 0; seed < 40000; ++seed) {
    const Vec3 towards = cosine_direction(normal, sample_point(0, seed));
    EXPECT_NEAR(towards.norm(), 1.0f, 1e-5f);
    const auto cosine = static_cast<double>(towards.dot(normal));
    first.add(cosine);
    second.add(cosine * cosine);
    across.add(static_cast<double>(towards.dot(frame.a)));
  }
  test::expect_mean(first, 2.0 / 3.0, 0.002, 1e-6);
  test::expect_mean(second, 0.5, 0.002, 1e-6);
  test::expect_mean(across, 0.0, 0.004, 1e-6);
}

// An even density on a cap has an even cos θ: mean (1 + c)/2, E[cos² θ] = (1 + c + c²)/3.
TEST(ConeDirection, IsEvenOverItsCap) {
  for (const float least : {0.2f, 0.7f, 0.995f}) {
    const double c = static_cast<double>(least);
    test::SampleMean first, second;
    for (std::uint32_t seed = 0; seed < 40000; ++seed) {
      const Vec3 towards = cone_direction(Vec3::UnitX(), least, sample_point(0, seed));
      EXPECT_GE(towards.x(), least - 1e-5f);
      first.add(static_cast<double>(towards.x()));
      second.add(static_cast<double>(towards.x() * towards.x()));
    }
    test::expect_mean(first, 0.5 * (1.0 + c), 0.002 * (1.0 - c), 1e-6);
    test::expect_mean(second, (1.0 + c + c * c) / 3.0, 0.004 * (1.0 - c), 1e-6);
  }
}

}  // namespace
}  // namespace mien::render
