#include "pipeline/regression/comparison/distinct_numbers.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

TEST(DistinctNumbers, HaveTheDigitsByWhichTheyDiffer) {
  EXPECT_EQ(distinct_numbers(3.2, 3.2), (std::pair<std::string, std::string>("3.2", "3.2")));
  EXPECT_EQ(distinct_numbers(3.2, 3.20000001),
            (std::pair<std::string, std::string>("3.2", "3.20000001")));
  EXPECT_EQ(distinct_numbers(120.0, 119.98, 4),
            (std::pair<std::string, std::string>("120", "119.98")));
}

TEST(DistinctNumbers, NeverReadTheSameUnlessTheyAre) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(1e-3, 1e3);
  for (int i = 0; i < 1000; ++i) {
    const double a = any(random), b = std::nextafter(a, 2000.0);
    const auto [before, now] = distinct_numbers(a, b, 1);
    EXPECT_NE(before, now) << a;
  }
}

}  // namespace
}  // namespace mien::pipeline
