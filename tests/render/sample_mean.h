#pragma once

#include <cmath>

#include <gtest/gtest.h>

namespace mien::render::test {

/// Mean of independent estimates and how far it may be off.
class SampleMean {
 public:
  void add(double estimate) {
    ++count_;
    const double step = estimate - mean_;
    mean_ += step / count_;
    squares_ += step * (estimate - mean_);
  }
  double mean() const { return mean_; }
  double standard_error() const { return std::sqrt(squares_ / (count_ - 1.0) / count_); }

 private:
  double count_ = 0.0;
  double mean_ = 0.0;
  double squares_ = 0.0;  // of deviations from the mean
};

/// Two-sided z-test at 0.01 %: fails when the mean is further from `expected` than 3.89 standard
/// errors and `rounding`. It fails too when the standard error is above `resolution`, so that it
/// always sees a bias of about five of those.
inline void expect_mean(const SampleMean& estimates, double expected, double resolution,
                        double rounding) {
  EXPECT_LE(estimates.standard_error(), resolution);
  EXPECT_NEAR(estimates.mean(), expected, 3.89 * estimates.standard_error() + rounding);
}

}  // namespace mien::render::test
