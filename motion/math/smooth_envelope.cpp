#include "motion/math/smooth_envelope.h"

#include <algorithm>
#include <cmath>

#include "motion/math/geometry.h"

namespace mien::motion {

std::vector<double> smooth_envelope(const std::vector<double>& needed, int half_width, bool loops) {
  const int count = static_cast<int>(needed.size());
  const auto at = [&](int f) {
    return static_cast<size_t>(loops ? ((f % count) + count) % count : std::clamp(f, 0, count - 1));
  };
  std::vector<double> widened(needed.size());
  for (int f = 0; f < count; ++f) {
    for (int k = -half_width; k <= half_width; ++k) {
      widened[at(f)] = std::max(widened[at(f)], needed[at(f + k)]);
    }
  }
  std::vector<double> smooth(needed.size());
  for (int f = 0; f < count; ++f) {
    double sum = 0.0;
    double weight = 0.0;
    for (int k = -half_width; k <= half_width; ++k) {
      const double w = 1.0 + std::cos(pi * k / (half_width + 1));
      sum += w * widened[at(f + k)];
      weight += w;
    }
    smooth[at(f)] = sum / weight;
  }
  return smooth;
}

double fade(double x) {
  if (x <= 0.0) return 1.0;
  if (x >= 1.0) return 0.0;
  return 2.0 * x * x * x - 3.0 * x * x + 1.0;
}

}  // namespace mien::motion
