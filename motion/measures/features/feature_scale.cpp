#include "motion/measures/features/feature_scale.h"

#include <algorithm>
#include <cassert>
#include <cmath>

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

std::optional<FeatureGroup> group_with_id(std::string_view id) {
  for (int g = 0; g < feature_group_count; ++g) {
    const auto group = static_cast<FeatureGroup>(g);
    if (id_of(group) == id) return group;
  }
  return std::nullopt;
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

std::vector<std::string> feature_parameter_names() {
  std::vector<std::string> names;
  for (int g = 0; g < feature_group_count; ++g) {
    names.emplace_back(id_of(static_cast<FeatureGroup>(g)));
  }
  for (const MotionFeature& feature : motion_features()) names.emplace_back(feature.id);
  return names;
}

std::optional<double> feature_parameter(std::string_view name, const FeatureValues& scaled_values) {
  if (const auto group = group_with_id(name)) return group_mean(scaled_values, *group);
  const int index = find_motion_feature(name);
  assert(index >= 0);
  const double value = scaled_values[static_cast<std::size_t>(index)];
  if (std::isnan(value)) return std::nullopt;
  return value;
}

}  // namespace mien::motion
