#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace mien::pipeline {

/// A rational number for exact arithmetic with answers. Answers are points of a scale or have few
/// decimals, so that they, their sums, means and differences of means are fractions of integers.
/// Equal means are then equal to the last bit, independent of the order of summation, so that ties
/// and differences of 0 are detected exactly.
///
/// A value that is not such a fraction (a measured distance with all its digits), has a magnitude
/// of 10⁹ or more, or results from a calculation that exceeds 64 bits is kept as a double.
class ExactNumber {
 public:
  ExactNumber() = default;

  /// The first convergent of the continued fraction of `value` that differs from it by at most
  /// 2⁻⁵⁰ · max(1, |value|): 2/3 for 0.6666666666666666, 1/10 for 0.1. The double itself if the
  /// denominator of that fraction would exceed 1,000,000.
  static ExactNumber of(double value);

  /// Nearest double; identical for equal numbers.
  double value() const;
  /// Whether the number is still an exact fraction.
  bool is_exact() const { return fraction_.has_value(); }

  ExactNumber operator-() const;
  friend ExactNumber operator+(const ExactNumber& a, const ExactNumber& b);
  friend ExactNumber operator-(const ExactNumber& a, const ExactNumber& b) { return a + -b; }
  friend ExactNumber operator*(const ExactNumber& a, std::int64_t factor);
  /// `divisor` must be positive.
  friend ExactNumber operator/(const ExactNumber& a, std::int64_t divisor);
  ExactNumber& operator+=(const ExactNumber& other) { return *this = *this + other; }

 private:
  /// Numerator and positive denominator in lowest terms.
  struct Fraction {
    std::int64_t numerator = 0;
    std::int64_t denominator = 1;
  };

  explicit ExactNumber(std::optional<Fraction> fraction, double rounded);

  std::optional<Fraction> fraction_ = Fraction{};
  double rounded_ = 0.0;  ///< used if there is no fraction
};

/// Sum and number of answers.
struct ExactSum {
  ExactNumber sum;
  int count = 0;

  void add(const ExactNumber& value) {
    sum += value;
    ++count;
  }
  /// The mean; requires at least one value.
  ExactNumber mean() const { return sum / count; }
};

/// The mean of numbers, exact if they are fractions; NaN for an empty list.
double exact_mean(std::span<const double> values);

}  // namespace mien::pipeline
