#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/measures/features/motion_features.h"

namespace mien::motion {

enum class FeatureScaling {
  min_max,  ///< 0 at the smallest of the examples, 1 at the largest; 0.5 for a constant feature
            ///< (default)
  z_score,  ///< 0 at the mean, 1 at one (population) standard deviation above; 0 for a constant
            ///< feature
};

/// Makes features of different units comparable: (value − origin) / span, feature by feature.
struct FeatureScale {
  FeatureValues origin{};
  FeatureValues span{};      ///< 0 if all examples are equal; NaN if an example lacks the feature
  double of_constant = 0.5;  ///< scaled value of a feature whose span is 0
};

/// Fits the scale to at least one example. Differences below 1e-6 (in the feature's unit) are
/// treated as rounding errors, that is, as no difference.
FeatureScale fit_feature_scale(std::span<const FeatureValues> examples,
                               FeatureScaling how = FeatureScaling::min_max);

/// Returns the scaled values; NaN where an example lacks the feature, and where the motion lacks it
/// unless it is constant over the examples. Values are not clipped: with `min_max`, those of a
/// motion beyond the range of the examples lie outside [0, 1].
FeatureValues scaled(const FeatureScale& scale, const FeatureValues& values);

/// A primary feature parameter: the mean of the group's features, ignoring NaN. Empty if all are
/// NaN.
std::optional<double> group_mean(const FeatureValues& scaled_values, FeatureGroup group);

/// Names of all feature parameters: the four groups ("lateral-swing", …), then the 51 features.
std::vector<std::string> feature_parameter_names();

/// Value of a feature parameter for a motion whose scaled features are given; empty if the motion
/// lacks the feature. `name` is one of `feature_parameter_names`.
std::optional<double> feature_parameter(std::string_view name, const FeatureValues& scaled_values);

}  // namespace mien::motion
