#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/measures/features/motion_features.h"

namespace mien::motion {

/// Names of all feature parameters: the four groups ("lateral-swing", …), then the 51 features.
std::vector<std::string> feature_parameter_names();

/// Value of a feature parameter for a motion whose scaled features are given; empty when the motion
/// has no such feature. `name` is one of `feature_parameter_names`.
std::optional<double> feature_parameter(std::string_view name, const FeatureValues& scaled_values);

}  // namespace mien::motion
