// Sensitivities against published values and R (reference/signal_detection.R), and simulated
// observers whose d′ is known.

#include "pipeline/base/statistics/signal_detection.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

TEST(Detection, HasThePublishedSensitivities) {
  // Macmillan and Creelman 2005: d′ by z of table A5.1.
  EXPECT_NEAR(yes_no_d({0.9, 0.2}), 2.123, 5e-4);
  EXPECT_NEAR(yes_no_d({0.8, 0.4}), 1.095, 5e-4);
  EXPECT_NEAR(yes_no_d({0.5, 0.5}), 0.0, 1e-12);
}

TEST(Detection, HasTheSensitivitiesAndErrorsOfR) {
  const Sensitivity usual = yes_no_sensitivity({20, 18, 20, 4});
  EXPECT_NEAR(usual.d, 1.971399725355, 1e-9);
  EXPECT_NEAR(usual.error, 0.481154013756, 1e-9);
  EXPECT_NEAR(usual.criterion, -0.194061254934, 1e-9);
  EXPECT_NEAR(usual.d_ends.low, 1.971399725355 - 1.959963985 * 0.481154013756, 1e-8);
  EXPECT_NEAR(usual.criterion_ends.high, -0.194061254934 + 0.5 * 1.959963985 * 0.481154013756,
              1e-8);
  const Sensitivity extreme = yes_no_sensitivity({40, 40, 30, 0});
  EXPECT_NEAR(extreme.d, 4.3921238174748, 1e-9);
  EXPECT_NEAR(extreme.error, 0.7910921787725, 1e-9);
}

TEST(Detection, OfTwoIntervalsIsSmallerByTheRootOfTwo) {
  const DetectionCounts counts{20, 18, 20, 4};
  const Sensitivity one = yes_no_sensitivity(counts), two = two_interval_sensitivity(counts);
  EXPECT_NEAR(two.d, one.d / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(two.error, one.error / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(two.d_ends.high - two.d_ends.low, (one.d_ends.high - one.d_ends.low) / std::sqrt(2.0),
              1e-12);
  EXPECT_EQ(two.criterion, one.criterion);
  EXPECT_EQ(two.criterion_ends.low, one.criterion_ends.low);
}

TEST(Detection, IsUnknownWithoutSignalOrNoise) {
  for (const DetectionCounts& counts : {DetectionCounts{0, 0, 9, 3}, DetectionCounts{9, 3, 0, 0}}) {
    EXPECT_TRUE(std::isnan(yes_no_sensitivity(counts).d));
    EXPECT_TRUE(std::isnan(two_interval_sensitivity(counts).d));
    EXPECT_TRUE(std::isnan(same_different_sensitivity(counts).d));
  }
}

TEST(SameDifferent, HasTheSensitivitiesOfR) {
  EXPECT_NEAR(differencing_d({0.642, 0.3}), 1.95061530843, 1e-9);
  EXPECT_NEAR(differencing_d({0.5, 0.1}), 2.32438869083, 1e-9);
  EXPECT_NEAR(differencing_d({0.7, 0.3}), 2.18751971234, 1e-9);
  EXPECT_NEAR(differencing_d({0.9, 0.1}), 4.13854237773, 1e-9);
  EXPECT_EQ(differencing_d({0.3, 0.3}), 0.0);
  EXPECT_EQ(differencing_d({0.2, 0.3}), 0.0);
}

TEST(SameDifferent, HasTheIntervalsOfR) {
  const Sensitivity clear = same_different_sensitivity({40, 30, 40, 12});
  EXPECT_NEAR(clear.d, 2.36259734162, 1e-8);
  EXPECT_NEAR(clear.d_ends.low, 1.58240143273, 1e-6);
  EXPECT_NEAR(clear.d_ends.high, 3.11841812628, 1e-6);
  const Sensitivity unclear = same_different_sensitivity({40, 13, 40, 12});
  EXPECT_NEAR(unclear.d, 0.452893291191, 1e-8);
  EXPECT_EQ(unclear.d_ends.low, 0.0);
  EXPECT_NEAR(unclear.d_ends.high, 1.496044366039, 1e-6);
  const Sensitivity none = same_different_sensitivity({40, 8, 40, 12});
  EXPECT_EQ(none.d, 0.0);
  EXPECT_EQ(none.d_ends.low, 0.0);
  EXPECT_GT(none.d_ends.high, 0.3);
}

TEST(SameDifferent, HasFiniteIntervalsForAllCounts) {
  for (int hits = 0; hits <= 6; ++hits) {
    for (int alarms = 0; alarms <= 6; ++alarms) {
      const Sensitivity found = same_different_sensitivity({6, hits, 6, alarms});
      EXPECT_GE(found.d_ends.low, 0.0);
      EXPECT_LE(found.d_ends.low, found.d + 1e-9) << hits << " " << alarms;
      EXPECT_GE(found.d_ends.high, found.d) << hits << " " << alarms;
      EXPECT_LT(found.d_ends.high, 12.0) << hits << " " << alarms;
      EXPECT_GT(found.criterion, 0.0);
    }
  }
}

/// An observer whose observations have a standard deviation of 1.
class Observer {
 public:
  explicit Observer(double d) : d_(d) {}

  DetectionCounts yes_no(int trials, double criterion) {
    return counted(trials, [&](bool is_signal) { return seen(is_signal) > criterion; });
  }
  DetectionCounts two_interval(int trials, double bias) {
    return counted(trials, [&](bool is_first) { return seen(is_first) - seen(!is_first) > bias; });
  }
  DetectionCounts same_different(int trials, double k) {
    return counted(
        trials, [&](bool is_different) { return std::abs(seen(is_different) - seen(false)) > k; });
  }

 private:
  double seen(bool is_signal) { return (is_signal ? d_ : 0.0) + noise_(random_); }

  static DetectionCounts counted(int trials, auto&& is_positive) {
    DetectionCounts counts{trials, 0, trials, 0};
    for (int i = 0; i < trials; ++i) {
      counts.hits += is_positive(true) ? 1 : 0;
      counts.false_alarms += is_positive(false) ? 1 : 0;
    }
    return counts;
  }

  double d_;
  std::mt19937_64 random_{19};
  std::normal_distribution<double> noise_;
};

TEST(Sensitivity, OfSimulatedObserversIsFound) {
  constexpr int trials = 200000;
  for (const double d : {0.5, 1.5, 2.5}) {
    Observer observer(d);
    const Sensitivity yes_no = yes_no_sensitivity(observer.yes_no(trials, 0.8));
    EXPECT_NEAR(yes_no.d, d, 4.0 * yes_no.error);
    EXPECT_NEAR(yes_no.criterion, 0.8 - 0.5 * d, 2.0 * yes_no.error);
    const Sensitivity interval = two_interval_sensitivity(observer.two_interval(trials, 0.3));
    EXPECT_NEAR(interval.d, d, 4.0 * interval.error);
    EXPECT_NEAR(interval.criterion, 0.3 / std::sqrt(2.0), 0.02);
    const Sensitivity pair = same_different_sensitivity(observer.same_different(trials, 1.2));
    EXPECT_NEAR(pair.d, d, 0.03);
    EXPECT_NEAR(pair.criterion, 1.2, 0.02);
  }
}

/// Share of intervals that hold the true d′, in simulated studies of so many trials of each kind.
double coverage_of(double d, auto&& study) {
  constexpr int studies = 2000;
  Observer observer(d);
  int held = 0;
  for (int i = 0; i < studies; ++i) {
    const Interval95 ends = study(observer).d_ends;
    held += ends.low <= d && d <= ends.high ? 1 : 0;
  }
  return 1.0 * held / studies;
}

TEST(Sensitivity, IsHeldByItsIntervalAsOftenAsStated) {
  // 2000 studies: standard error 0.5 %.
  for (const double d : {0.0, 1.0, 2.0}) {
    const double yes_no = coverage_of(
        d, [](Observer& observer) { return yes_no_sensitivity(observer.yes_no(40, 0.5)); });
    const double interval = coverage_of(d, [](Observer& observer) {
      return two_interval_sensitivity(observer.two_interval(40, 0.0));
    });
    const double pair = coverage_of(d, [](Observer& observer) {
      return same_different_sensitivity(observer.same_different(60, 1.5));
    });
    RecordProperty(
        "coverage of yes_no, two_interval, same_different at d' " + std::to_string(d),
        std::to_string(yes_no) + " " + std::to_string(interval) + " " + std::to_string(pair));
    for (const double coverage : {yes_no, interval, pair}) {
      EXPECT_GT(coverage, 0.93) << d;
      EXPECT_LT(coverage, 0.99) << d;
    }
  }
}

}  // namespace
}  // namespace mien::pipeline
