#include "motion/math/random_number.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

TEST(RandomBits, AreThoseOfSplitMix64) {
  // The reference implementation's, seed 1234567 (Vigna 2015).
  const std::uint64_t published[] = {6457827717110365317u, 3203168211198807973u,
                                     9817491932198370423u, 4593380528125082431u,
                                     16408922859458223821u};
  for (std::uint64_t n = 0; n < 5; ++n) EXPECT_EQ(random_bits(1234567, n), published[n]);
}

TEST(RandomBits, AsNumbersStayWithinTheirEnds) {
  for (const std::uint64_t bits : {std::uint64_t{0}, ~std::uint64_t{0}}) {
    EXPECT_GE(centred_number(bits), -1.0);
    EXPECT_LT(centred_number(bits), 1.0);
    EXPECT_GT(open_unit_number(bits), 0.0);
    EXPECT_LT(open_unit_number(bits), 1.0);
    EXPECT_TRUE(std::isfinite(std::log(open_unit_number(bits))));
  }
}

TEST(RandomNumber, OfANameHasTheMomentsOfTheUniformDistribution) {
  constexpr int count = 20000;
  double sum = 0.0;
  double squares = 0.0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const double x = random_number(7, "dot", i);
    sum += x;
    squares += x * x;
  }
  // Five standard errors: the variance of x is 1/3, that of x² is 4/45.
  EXPECT_NEAR(sum / count, 0.0, 5.0 * std::sqrt(1.0 / 3.0 / count));
  EXPECT_NEAR(squares / count, 1.0 / 3.0, 5.0 * std::sqrt(4.0 / 45.0 / count));
}

TEST(RandomNumber, DependsOnSeedNameAndIndex) {
  EXPECT_EQ(random_number(1, "a", 2), random_number(1, "a", 2));
  EXPECT_NE(random_number(1, "a", 2), random_number(2, "a", 2));
  EXPECT_NE(random_number(1, "a", 2), random_number(1, "b", 2));
  EXPECT_NE(random_number(1, "a", 2), random_number(1, "a", 3));
}

}  // namespace
}  // namespace mien::motion
