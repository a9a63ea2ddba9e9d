#include "pipeline/base/statistics/wilcoxon.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

using Mode = WilcoxonMode;

/// Differences of n pairs whose W+ is the given whole number: the ranks that sum up to it are
/// taken from the largest down.
std::vector<double> with_w_plus(int n, int w) {
  std::vector<double> differences;
  for (int rank = n; rank >= 1; --rank) {
    const bool positive = rank <= w;
    differences.push_back(positive ? rank : -rank);
    if (positive) w -= rank;
  }
  return differences;
}

/// Two-sided p by trying every sign.
double by_enumeration(const std::vector<double>& differences) {
  const double observed = wilcoxon(differences).w_plus;
  int at_most = 0;
  int at_least = 0;
  const unsigned all = 1U << differences.size();
  for (unsigned signs = 0; signs < all; ++signs) {
    std::vector<double> turned = differences;
    for (size_t i = 0; i < turned.size(); ++i) {
      turned[i] = (signs >> i & 1U) != 0 ? std::abs(turned[i]) : -std::abs(turned[i]);
    }
    const double w = wilcoxon(turned, Mode::published).w_plus;
    at_most += w <= observed;
    at_least += w >= observed;
  }
  return std::min(1.0, 2.0 * std::min(at_most, at_least) / all);
}

TEST(Wilcoxon, MatchesRsDepressionExample) {
  const std::vector<double> x = {1.83, .50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30};
  const std::vector<double> y = {.878, .647, .598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29};
  std::vector<double> d;
  for (size_t i = 0; i < x.size(); ++i) d.push_back(x[i] - y[i]);
  const Wilcoxon test = wilcoxon(d);
  EXPECT_EQ(test.w_plus, 40.0);
  EXPECT_EQ(test.used, 9);
  EXPECT_NEAR(test.p, 0.0390625, 1e-15);
  EXPECT_NEAR(test.rank_biserial, 35.0 / 45.0, 1e-15);
}

TEST(Wilcoxon, LeastExactValuesAreThoseOfTheTables) {
  EXPECT_NEAR(wilcoxon(with_w_plus(5, 0)).p, 0.0625, 1e-15);
  EXPECT_NEAR(wilcoxon(with_w_plus(6, 0)).p, 0.03125, 1e-15);
  EXPECT_NEAR(wilcoxon(with_w_plus(10, 0)).p, 0.001953125, 1e-15);
  EXPECT_NEAR(wilcoxon(with_w_plus(13, 0)).p, 0.000244140625, 1e-15);
}

TEST(Wilcoxon, PaperModeOfThirteenPairsGivesTheKnownValues) {
  const std::vector<std::pair<int, double>> known = {
      {0, 0.0015}, {9, 0.0107}, {24, 0.1330}, {33, 0.3824}, {42, 0.8068}};
  for (const auto& [w, p] : known) {
    const Wilcoxon test = wilcoxon(with_w_plus(13, w), Mode::published);
    ASSERT_EQ(test.w_plus, w);
    EXPECT_NEAR(test.p, p, 5e-5) << w;
  }
}

TEST(Wilcoxon, TiesAndAZeroAreTreatedAsKnown) {
  const std::vector<double> d = {1, 1, 2, 3, -1, 0, 4, 5};
  EXPECT_EQ(wilcoxon(d).w_plus, 26.0);
  EXPECT_EQ(wilcoxon(d).pairs, 8);
  EXPECT_EQ(wilcoxon(d).used, 7);
  EXPECT_NEAR(wilcoxon(d).p, 0.0625, 1e-15);
  EXPECT_NEAR(wilcoxon(d, Mode::published).p, 0.04105, 5e-6);
  EXPECT_NEAR(wilcoxon(d, Mode::corrected).p, 0.05024, 5e-6);
  EXPECT_NEAR(wilcoxon(d, Mode::published, WilcoxonZeros::pratt).p, 0.04081, 5e-6);
}

TEST(Wilcoxon, MatchesRsSleepExample) {
  // Extra sleep, drug 1 less drug 2 (Student 1908).
  const std::vector<double> d = {-1.2, -2.4, -1.3, -1.3, 0.0, -1.0, -1.8, -0.8, -4.6, -1.4};
  EXPECT_NEAR(wilcoxon(d, Mode::corrected).p, 0.0090907, 5e-7);
}

TEST(Wilcoxon, ExactValuesAreThoseOfTryingEverySign) {
  std::mt19937 random(4);
  std::uniform_int_distribution<int> size(1, 9);
  // Few values, so that most sets have ties.
  std::uniform_int_distribution<int> value(1, 5);
  for (int trial = 0; trial < 60; ++trial) {
    std::vector<double> d(static_cast<size_t>(size(random)));
    for (double& x : d) x = value(random) * (random() % 3 == 0 ? -1.0 : 1.0);
    EXPECT_NEAR(wilcoxon(d).p, by_enumeration(d), 1e-12);
  }
}

TEST(Wilcoxon, TurningTheDifferencesRoundMirrorsIt) {
  std::mt19937 random(9);
  std::normal_distribution<double> value(0.3, 1.0);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<double> d(15);
    std::vector<double> turned;
    for (double& x : d) turned.push_back(-(x = value(random)));
    for (const Mode mode : {Mode::exact, Mode::published, Mode::corrected}) {
      EXPECT_NEAR(wilcoxon(d, mode).p, wilcoxon(turned, mode).p, 1e-12);
      EXPECT_NEAR(wilcoxon(d, mode).rank_biserial, -wilcoxon(turned, mode).rank_biserial, 1e-15);
      EXPECT_EQ(wilcoxon(d, mode).w_plus, wilcoxon(turned, mode).w_minus);
    }
  }
}

TEST(Wilcoxon, ExactAndNormalMeetForManyPairs) {
  std::mt19937 random(2);
  std::normal_distribution<double> value(0.05, 1.0);
  std::vector<double> d(300);
  for (double& x : d) x = value(random);
  EXPECT_NEAR(wilcoxon(d).p, wilcoxon(d, Mode::corrected).p, 2e-3);
}

TEST(Wilcoxon, OfNoDifferenceIsCertainOfNothing) {
  for (const Mode mode : {Mode::exact, Mode::published, Mode::corrected}) {
    EXPECT_EQ(wilcoxon({0.0, 0.0}, mode).p, 1.0);
    EXPECT_EQ(wilcoxon({1.0, -1.0}, mode).p, 1.0);
  }
}

TEST(Wilcoxon, WithoutDifferencesIsNoTest) {
  for (const Mode mode : {Mode::exact, Mode::published, Mode::corrected}) {
    EXPECT_TRUE(std::isnan(wilcoxon({}, mode).p));
    EXPECT_TRUE(std::isnan(wilcoxon({}, mode).rank_biserial));
  }
}

}  // namespace
}  // namespace mien::pipeline
