#include "motion/measures/features/feature_parameter.h"

#include <cassert>
#include <cmath>

#include "motion/measures/features/feature_scale.h"

namespace mien::motion {

namespace {

std::optional<FeatureGroup> group_with_id(std::string_view id) {
  for (int g = 0; g < feature_group_count; ++g) {
    const auto group = static_cast<FeatureGroup>(g);
    if (id_of(group) == id) return group;
  }
  return std::nullopt;
}

}  // namespace

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
