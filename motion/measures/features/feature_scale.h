#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/measures/features/motion_features.h"

namespace mien::motion {

enum class FeatureScaling {
  min_max,  ///< 0 at the smallest of the examples, 1 at the largest; a constant is 0.5. Default
  z_score,  ///< 0 at the mean, 1 a standard deviation (n) above; a constant is 0
};

/// Makes features of different units comparable: (value − origin) / span, feature by feature.
struct FeatureScale {
  FeatureValues origin{};
  FeatureValues span{};  ///< 0 where the examples do not differ; NaN where one has no such feature
  double of_constant = 0.5;
};

/// Fits the scale to examples, of which there must be one at least. Differences below 1e-6 (of a
/// degree, metre, …) are those of arithmetic and count as none.
FeatureScale fit_feature_scale(std::span<const FeatureValues> examples,
                               FeatureScaling how = FeatureScaling::min_max);

/// Scaled values; NaN where the examples or the motion have no such feature. Not clipped: a motion
/// beyond the examples lies outside [0, 1].
FeatureValues scaled(const FeatureScale& scale, const FeatureValues& values);

/// A primary feature parameter: the mean of the group's features; those that are NaN do not count.
/// Empty when all are.
std::optional<double> group_mean(const FeatureValues& scaled_values, FeatureGroup group);

/// Names of all feature parameters: the four groups ("lateral-swing", …), then the 51 features.
std::vector<std::string> feature_parameter_names();

/// Value of a feature parameter for a motion whose scaled features are given; empty when the motion
/// has no such feature. `name` is one of `feature_parameter_names`.
std::optional<double> feature_parameter(std::string_view name, const FeatureValues& scaled_values);

}  // namespace mien::motion
