#include "pipeline/ratings/feature_parameters.h"

#include <cassert>
#include <cmath>

namespace mien::pipeline {

namespace {

std::optional<motion::FeatureGroup> find_group(std::string_view id) {
  for (int g = 0; g < motion::feature_group_count; ++g) {
    const auto group = static_cast<motion::FeatureGroup>(g);
    if (motion::id_of(group) == id) return group;
  }
  return std::nullopt;
}

}  // namespace

FeatureParameters feature_parameters(const motion::ExampleSet& examples) {
  FeatureParameters result;
  if (examples.examples.empty()) return result;
  for (const motion::Example& example : examples.examples) {
    result.values.push_back(motion::measure_features(example));
  }
  result.scale = motion::fit_feature_scale(result.values);
  const auto count = static_cast<Eigen::Index>(examples.examples.size());
  std::vector<Eigen::RowVectorXd> rows;
  for (const std::string& name : feature_parameter_names()) {
    Eigen::RowVectorXd row(count);
    bool all_have_it = true;
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto value = feature_parameter(
          name, motion::scaled(result.scale, result.values[static_cast<std::size_t>(i)]));
      all_have_it = all_have_it && value.has_value();
      row[i] = value.value_or(0.0);
    }
    if (!all_have_it) continue;
    result.table.names.push_back(name);
    rows.push_back(std::move(row));
  }
  result.table.values.resize(static_cast<Eigen::Index>(rows.size()), count);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    result.table.values.row(static_cast<Eigen::Index>(r)) = rows[r];
  }
  return result;
}

std::vector<std::string> feature_parameter_names() {
  std::vector<std::string> names;
  for (int g = 0; g < motion::feature_group_count; ++g) {
    names.emplace_back(motion::id_of(static_cast<motion::FeatureGroup>(g)));
  }
  for (const motion::MotionFeature& feature : motion::motion_features()) {
    names.emplace_back(feature.id);
  }
  return names;
}

std::optional<double> feature_parameter(std::string_view name,
                                        const motion::FeatureValues& scaled_values) {
  if (const auto group = find_group(name)) return motion::group_mean(scaled_values, *group);
  const int index = motion::find_motion_feature(name);
  assert(index >= 0);
  const double value = scaled_values[static_cast<std::size_t>(index)];
  if (std::isnan(value)) return std::nullopt;
  return value;
}

}  // namespace mien::pipeline
