#include "pipeline/base/statistics/exact_number.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace mien::pipeline {

namespace {

constexpr std::int64_t most_denominator = 1'000'000;
constexpr double most_above = 1e9;

bool is_product(std::int64_t a, std::int64_t b, std::int64_t& product) {
  return !__builtin_mul_overflow(a, b, &product);
}

}  // namespace

ExactNumber::ExactNumber(std::optional<Fraction> fraction, double rounded)
    : fraction_(fraction), rounded_(rounded) {}

// Continued fractions: of all with no larger denominator, each convergent is the nearest.
ExactNumber ExactNumber::of(double value) {
  const double size = std::abs(value);
  if (!(size < most_above)) return ExactNumber(std::nullopt, value);
  const double slack = 4.0 * std::numeric_limits<double>::epsilon() * std::max(1.0, size);
  double rest = size;
  Fraction before{1, 0};
  auto now = Fraction{static_cast<std::int64_t>(std::floor(rest)), 1};
  while (std::abs(static_cast<double>(now.numerator) / static_cast<double>(now.denominator) -
                  size) > slack) {
    rest = 1.0 / (rest - std::floor(rest));
    if (!(rest < static_cast<double>(2 * most_denominator)))
      return ExactNumber(std::nullopt, value);
    const auto whole = static_cast<std::int64_t>(std::floor(rest));
    const Fraction next{whole * now.numerator + before.numerator,
                        whole * now.denominator + before.denominator};
    if (next.denominator > most_denominator) return ExactNumber(std::nullopt, value);
    before = now;
    now = next;
  }
  if (value < 0.0) now.numerator = -now.numerator;
  return ExactNumber(now, 0.0);
}

double ExactNumber::value() const {
  if (!fraction_) return rounded_;
  return static_cast<double>(static_cast<long double>(fraction_->numerator) /
                             static_cast<long double>(fraction_->denominator));
}

ExactNumber ExactNumber::operator-() const {
  ExactNumber result = *this;
  if (result.fraction_) result.fraction_->numerator = -result.fraction_->numerator;
  result.rounded_ = -result.rounded_;
  return result;
}

ExactNumber operator+(const ExactNumber& a, const ExactNumber& b) {
  if (a.fraction_ && b.fraction_) {
    const std::int64_t common = std::gcd(a.fraction_->denominator, b.fraction_->denominator);
    std::int64_t first = 0;
    std::int64_t second = 0;
    std::int64_t numerator = 0;
    std::int64_t denominator = 0;
    if (is_product(a.fraction_->numerator, b.fraction_->denominator / common, first) &&
        is_product(b.fraction_->numerator, a.fraction_->denominator / common, second) &&
        is_product(a.fraction_->denominator, b.fraction_->denominator / common, denominator) &&
        !__builtin_add_overflow(first, second, &numerator) &&
        numerator != std::numeric_limits<std::int64_t>::min()) {
      const std::int64_t shared = std::gcd(numerator, denominator);
      return ExactNumber(ExactNumber::Fraction{numerator / shared, denominator / shared}, 0.0);
    }
  }
  return ExactNumber(std::nullopt, a.value() + b.value());
}

ExactNumber operator*(const ExactNumber& a, std::int64_t factor) {
  if (a.fraction_) {
    const std::int64_t shared = std::gcd(factor, a.fraction_->denominator);
    std::int64_t numerator = 0;
    if (is_product(a.fraction_->numerator, factor / shared, numerator) &&
        numerator != std::numeric_limits<std::int64_t>::min())
      return ExactNumber(ExactNumber::Fraction{numerator, a.fraction_->denominator / shared}, 0.0);
  }
  return ExactNumber(std::nullopt, a.value() * static_cast<double>(factor));
}

ExactNumber operator/(const ExactNumber& a, std::int64_t divisor) {
  if (a.fraction_) {
    const std::int64_t shared = std::gcd(a.fraction_->numerator, divisor);
    std::int64_t denominator = 0;
    if (is_product(a.fraction_->denominator, divisor / shared, denominator))
      return ExactNumber(ExactNumber::Fraction{a.fraction_->numerator / shared, denominator}, 0.0);
  }
  return ExactNumber(std::nullopt, a.value() / static_cast<double>(divisor));
}

double exact_mean(std::span<const double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  ExactSum sum;
  for (const double value : values) sum.add(ExactNumber::of(value));
  return sum.mean().value();
}

}  // namespace mien::pipeline
