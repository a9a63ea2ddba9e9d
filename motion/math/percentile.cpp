#include "motion/math/percentile.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace mien::motion {

double percentile(std::span<const double> values, double percent) {
  assert(!values.empty());
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const double place = percent / 100.0 * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<size_t>(std::floor(place));
  const size_t above = std::min(below + 1, sorted.size() - 1);
  const double share = place - std::floor(place);
  return (1.0 - share) * sorted[below] + share * sorted[above];
}

}  // namespace mien::motion
