#include "motion/measures/features/feature_scale.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace mien::motion {

namespace {

constexpr double least_difference = 1e-6;

struct Line {
  double origin;
  double span;
};

Line fitted(const std::vector<double>& values, FeatureScaling how) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const bool constant = *most - *least < least_difference;
  if (how == FeatureScaling::min_max) return {*least, constant ? 0.0 : *most - *least};
  const auto count = static_cast<double>(values.size());
  double mean = 0.0;
  for (const double value : values) mean += value / count;
  double variance = 0.0;
  for (const double value : values) variance += (value - mean) * (value - mean) / count;
  return {mean, constant ? 0.0 : std::sqrt(variance)};
}

}  // namespace

FeatureScale fit_feature_scale(std::span<const FeatureValues> examples, FeatureScaling how) {
  assert(!examples.empty());
  FeatureScale scale;
  scale.of_constant = how == FeatureScaling::min_max ? 0.5 : 0.0;
  for (size_t i = 0; i < scale.origin.size(); ++i) {
    std::vector<double> values;
    for (const FeatureValues& example : examples) values.push_back(example[i]);
    const auto missing =
        std::find_if(values.begin(), values.end(), [](double v) { return std::isnan(v); });
    const Line line = missing == values.end() ? fitted(values, how) : Line{*missing, *missing};
    scale.origin[i] = line.origin;
    scale.span[i] = line.span;
  }
  return scale;
}

FeatureValues scaled(const FeatureScale& scale, const FeatureValues& values) {
  FeatureValues result;
  for (size_t i = 0; i < values.size(); ++i) {
    const bool constant = scale.span[i] == 0.0;
    result[i] = constant ? scale.of_constant : (values[i] - scale.origin[i]) / scale.span[i];
  }
  return result;
}

std::optional<double> group_mean(const FeatureValues& scaled_values, FeatureGroup group) {
  double sum = 0.0;
  int count = 0;
  for (size_t i = 0; i < scaled_values.size(); ++i) {
    if (motion_features()[i].group != group || std::isnan(scaled_values[i])) continue;
    sum += scaled_values[i];
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

}  // namespace mien::motion
