#include "pipeline/study/chains/experiment/sample_quantile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace mien::pipeline {

double quantile_of(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

}  // namespace mien::pipeline
