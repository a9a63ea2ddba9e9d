#include "pipeline/manifest/ratings/scales/feature_parameters.h"

namespace mien::pipeline {

std::vector<std::string> feature_group_names() {
  const auto& names = feature_parameter_names();
  return {names.begin(), names.begin() + motion::feature_group_count};
}

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

}  // namespace mien::pipeline
