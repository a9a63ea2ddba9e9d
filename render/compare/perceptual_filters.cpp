#include "render/compare/perceptual_filters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mien::render {
namespace {

/// Standard deviation of exp(−π² d² / b), in pixels.
double deviation_of(double b, double pixels_per_degree) {
  return std::sqrt(b / 2.0) / std::numbers::pi * pixels_per_degree;
}

int three_deviations(double deviation) { return static_cast<int>(std::ceil(3.0 * deviation)); }

/// Two-dimensional sum of an unnormalised Gaussian.
double whole_sum(double deviation, int reach) {
  double line = 1.0;
  for (int k = 1; k <= reach; ++k) line += 2.0 * std::exp(-0.5 * k * k / (deviation * deviation));
  return line * line;
}

/// Scales positive weights of both sides together to a sum of 1 and negative ones to −1.
HalfKernel balanced(const std::vector<double>& weights, bool odd) {
  double positive = 0.0, negative = 0.0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const double sides = k == 0 || odd ? 1.0 : 2.0;
    (weights[k] > 0.0 ? positive : negative) += sides * std::abs(weights[k]);
  }
  HalfKernel kernel;
  for (const double weight : weights)
    kernel.push_back(static_cast<float>(weight > 0.0 ? weight / positive
                                                     : (negative > 0.0 ? weight / negative : 0.0)));
  return kernel;
}

}  // namespace

ContrastFilters contrast_filters(double pixels_per_degree) {
  constexpr double wide_a = 34.1, wide_b = 0.04, narrow_a = 13.5, narrow_b = 0.025;
  const double wide = deviation_of(wide_b, pixels_per_degree);
  const double narrow = deviation_of(narrow_b, pixels_per_degree);
  const int reach = three_deviations(wide);
  const double wide_sum = wide_a / std::sqrt(wide_b) * whole_sum(wide, reach);
  const double narrow_sum = narrow_a / std::sqrt(narrow_b) * whole_sum(narrow, reach);
  return {.achromatic = gaussian_kernel(deviation_of(0.0047, pixels_per_degree), reach),
          .red_green = gaussian_kernel(deviation_of(0.0053, pixels_per_degree), reach),
          .blue_yellow = gaussian_kernel(wide, reach),
          .blue_yellow_narrow = gaussian_kernel(narrow, reach),
          .wide_share = static_cast<float>(wide_sum / (wide_sum + narrow_sum))};
}

FeatureFilters feature_filters(double pixels_per_degree) {
  const double deviation = 0.5 * 0.082 * pixels_per_degree;
  const int reach = std::max(1, three_deviations(deviation));
  std::vector<double> edge, point;
  for (int k = 0; k <= reach; ++k) {
    const double x = k / deviation;
    const double gaussian = std::exp(-0.5 * x * x);
    edge.push_back(k * gaussian);
    point.push_back((x * x - 1.0) * gaussian);
  }
  return {.smooth = gaussian_kernel(deviation, reach),
          .edge = balanced(edge, true),
          .point = balanced(point, false)};
}

}  // namespace mien::render
