#include "pipeline/base/statistics/benjamini_hochberg.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace mien::pipeline {

std::vector<double> benjamini_hochberg(const std::vector<double>& p_values) {
  std::vector<std::size_t> falling;
  for (std::size_t i = 0; i < p_values.size(); ++i)
    if (!std::isnan(p_values[i])) falling.push_back(i);
  std::ranges::stable_sort(falling, std::ranges::greater(),
                           [&](std::size_t i) { return p_values[i]; });
  const auto m = static_cast<double>(falling.size());
  std::vector<double> corrected = p_values;
  double least = 1.0;
  for (std::size_t k = 0; k < falling.size(); ++k) {
    least = std::min(least, m / (m - static_cast<double>(k)) * p_values[falling[k]]);
    corrected[falling[k]] = least;
  }
  return corrected;
}

}  // namespace mien::pipeline
