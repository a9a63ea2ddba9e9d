#include "render/math/powers.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mien::render {
namespace {

TEST(Powers, OfCubeRootAreThoseOfDoublePrecision) {
  for (double x = 1e-30; x < 1e9; x *= 1.037) {
    const double expected = std::cbrt(static_cast<double>(static_cast<float>(x)));
    EXPECT_NEAR(cube_root(static_cast<float>(x)), expected, 3e-7 * expected);
  }
  EXPECT_EQ(cube_root(0.0f), 0.0f);
  EXPECT_NEAR(cube_root(1.0f), 1.0f, 1.2e-7f);
  EXPECT_NEAR(cube_root(27.0f), 3.0f, 5e-7f);
}

TEST(Powers, OfLogarithmAndPowerOfTwoAreThoseOfDoublePrecision) {
  for (double x = 1e-30; x < 1e9; x *= 1.037) {
    const double expected = std::log2(static_cast<double>(static_cast<float>(x)));
    EXPECT_NEAR(binary_logarithm(static_cast<float>(x)), expected,
                3e-7 + 2.4e-7 * std::abs(expected));
  }
  for (float x = -126.0f; x < 127.0f; x += 0.173f) {
    const double expected = std::exp2(static_cast<double>(x));
    EXPECT_NEAR(power_of_two(x), expected, 3e-7 * expected);
  }
}

TEST(Powers, OfAnyBaseAndExponentAreThoseOfDoublePrecision) {
  for (const float exponent : {0.05f, 0.5f, 0.7f, 1.0f}) {
    for (double x = 1e-9; x < 1e6; x *= 1.11) {
      const double expected =
          std::pow(static_cast<double>(static_cast<float>(x)), static_cast<double>(exponent));
      EXPECT_NEAR(power(static_cast<float>(x), exponent), expected, 3e-6 * expected);
    }
    EXPECT_EQ(power(0.0f, exponent), 0.0f);
    EXPECT_EQ(power(1.0f, exponent), 1.0f);
  }
  EXPECT_EQ(power(0.0f, 0.0f), 1.0f);
}

}  // namespace
}  // namespace mien::render
