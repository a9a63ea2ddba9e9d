#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/measures/feature_scale.h"
#include "motion/skeleton/example.h"
#include "pipeline/ratings/parameter_table.h"

namespace mien::pipeline {

/// Measured features of the examples as parameters: nobody has to rate anything.
struct FeatureParameters {
  std::vector<motion::FeatureValues> values;  ///< one an example, in the features' own units
  motion::FeatureScale scale;                 ///< min–max over the examples
  ParameterTable table;  ///< the four groups, then the features that all examples have
};

FeatureParameters feature_parameters(const motion::ExampleSet& examples);

/// What `features:` may name: the four groups ("lateral-swing", …), then the 51 features.
std::vector<std::string> feature_parameter_names();

/// Value of a feature parameter for a motion whose scaled features are given; empty when the motion
/// has no such feature. `name` is one of `feature_parameter_names`.
std::optional<double> feature_parameter(std::string_view name,
                                        const motion::FeatureValues& scaled_values);

}  // namespace mien::pipeline
