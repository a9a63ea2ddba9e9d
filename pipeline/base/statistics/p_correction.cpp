#include "pipeline/base/statistics/p_correction.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace mien::pipeline {

std::vector<double> holm(const std::vector<double>& p_values) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < p_values.size(); ++i)
    if (!std::isnan(p_values[i])) order.push_back(i);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return p_values[i]; });
  std::vector<double> corrected = p_values;
  double largest = 0.0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto left = static_cast<double>(order.size() - k);
    largest = std::max(largest, std::min(1.0, left * p_values[order[k]]));
    corrected[order[k]] = largest;
  }
  return corrected;
}

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
