#include "render/math/filter.h"

#include <numbers>

namespace mien::render {
namespace {

// Sine by its series on −π … π: the table must not depend on a machine's libm.
double sine(double x) {
  double term = x, sum = x;
  for (int n = 1; n < 20; ++n) {
    term *= -x * x / ((2 * n) * (2 * n + 1));
    sum += term;
  }
  return sum;
}

// Share of the window's area left of x, for a window on −½ … ½.
double cumulated(double x) {
  const double angle = 2.0 * std::numbers::pi * x;
  // sin 2a and sin 3a by the angle formulas, to stay within −π … π.
  const double s1 = sine(angle);
  const double c1 = 1.0 - 2.0 * sine(0.5 * angle) * sine(0.5 * angle);
  const double s2 = 2.0 * s1 * c1;
  const double s3 = s1 * (3.0 - 4.0 * s1 * s1);
  const double area = 0.35875;
  return 0.5 + x +
         (0.48829 * s1 + 0.14128 * s2 / 2.0 + 0.01168 * s3 / 3.0) / (2.0 * std::numbers::pi * area);
}

double inverse_cumulated(double share) {
  double low = -0.5, high = 0.5;
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    (cumulated(middle) < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

constexpr int table_intervals = 1024;

// Ends of equal shares of the area of a window on −½ … ½.
const std::array<double, table_intervals + 1>& window_shares() {
  static const auto shares = [] {
    std::array<double, table_intervals + 1> result{};
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = inverse_cumulated(static_cast<double>(i) / table_intervals);
    return result;
  }();
  return shares;
}

}  // namespace

Filter::Filter(float width) {
  static_assert(intervals == table_intervals);
  for (std::size_t i = 0; i < offsets_.size(); ++i)
    offsets_[i] = width * static_cast<float>(window_shares()[i]);
  offsets_.front() = -0.5f * width;
  offsets_.back() = 0.5f * width;
}

}  // namespace mien::render
