#pragma once

#include <vector>

#include "motion/measures/features/feature_scale.h"
#include "motion/skeleton/example.h"
#include "pipeline/manifest/ratings/scales/parameter_table.h"

namespace mien::pipeline {

using motion::feature_parameter;
using motion::feature_parameter_names;

/// Measured features of the examples as parameters, which need no ratings.
struct FeatureParameters {
  std::vector<motion::FeatureValues> values;  ///< one per example, in the features' own units
  motion::FeatureScale scale;                 ///< minimum and maximum over the examples
  ParameterTable table;  ///< the groups, then the features, that are available for all examples
};

/// Returns the names of the groups of features, which precede those of the features in
/// feature_parameter_names().
std::vector<std::string> feature_group_names();

FeatureParameters feature_parameters(const motion::ExampleSet& examples);

}  // namespace mien::pipeline
