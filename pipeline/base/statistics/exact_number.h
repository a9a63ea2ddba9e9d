#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace mien::pipeline {

/// A number of an answer in exact arithmetic. Answers lie on few places of a scale or have few
/// decimals, so that they, their sums, their means and the differences of those are fractions of
/// whole numbers. Means of equal answers are then equal to the last bit, whatever was added first:
/// a tie is a tie, and no difference is 0.
///
/// What is no such fraction (a measured distance with all its digits), or has grown past 64 bits,
/// goes on as an ordinary double.
class ExactNumber {
 public:
  ExactNumber() = default;

  /// The fraction with the least denominator, at most 1,000,000, within 4 roundings of `value`:
  /// 2/3 of 0.6666666666666666, 1/10 of 0.1. There is never more than one.
  static ExactNumber of(double value);

  /// Nearest double; the same for equal numbers.
  double value() const;
  /// Whether nothing was rounded so far.
  bool is_exact() const { return fraction_.has_value(); }

  ExactNumber operator-() const;
  friend ExactNumber operator+(const ExactNumber& a, const ExactNumber& b);
  friend ExactNumber operator-(const ExactNumber& a, const ExactNumber& b) { return a + -b; }
  friend ExactNumber operator*(const ExactNumber& a, std::int64_t factor);
  /// `divisor` is above 0.
  friend ExactNumber operator/(const ExactNumber& a, std::int64_t divisor);
  ExactNumber& operator+=(const ExactNumber& other) { return *this = *this + other; }

 private:
  /// In lowest terms; below above 0.
  struct Fraction {
    std::int64_t above = 0;
    std::int64_t below = 1;
  };

  explicit ExactNumber(std::optional<Fraction> fraction, double rounded);

  std::optional<Fraction> fraction_ = Fraction{};
  double rounded_ = 0.0;  ///< where there is no fraction
};

/// Sum and number of answers.
struct ExactSum {
  ExactNumber sum;
  int count = 0;

  void add(const ExactNumber& value) {
    sum += value;
    ++count;
  }
  /// Of at least one.
  ExactNumber mean() const { return sum / count; }
};

/// The mean of numbers, exact where they are fractions; NaN of none.
double exact_mean(std::span<const double> values);

}  // namespace mien::pipeline
