#pragma once

#include <vector>

#include <Eigen/Core>

#include "motion/gait/foot_plant.h"
#include "motion/interpolation/interpolation.h"
#include "motion/live/slider_interface.h"
#include "motion/measures/features/feature_scale.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

/// Examples and options of motion synthesis: everything except the slider values.
struct SynthesisContext {
  const ExampleSet& examples;  ///< with settled feet if feet are locked (settled_feet.h)
  const SynthesisOptions& how;
  double frames_per_second = 30.0;
};

/// A synthesized motion as in a stimulus, with feet locked if the options specify it.
struct SynthesizedMotion {
  Example motion;
  InterpolatedWeights found;      ///< blend weights
  std::vector<FootPlant> plants;  ///< as detected before foot locking
};

/// Synthesizes a blend. If the set is not blendable, the example with the largest weight is used
/// instead.
SynthesizedMotion synthesize_from_weights(const Eigen::VectorXd& weights,
                                          const SynthesisContext& context);

/// Synthesizes the motion for slider values by the interpolation method of the interface.
SynthesizedMotion synthesize_at(const FittedInterface& interface,
                                const Eigen::RowVectorXd& settings,
                                const SynthesisContext& context);

/// Scale and table for measuring feature parameters. Measuring is necessary because the features of
/// a blend differ from the weighted sum of those of the examples.
struct FeatureTable {
  const FeatureScale& scale;    ///< scale of the features over the examples
  const ParameterTable& table;  ///< fallback for a feature that cannot be measured in the motion
};

/// The measured feature parameters of a motion, in the order of `names`.
Eigen::RowVectorXd measured_parameters(const std::vector<std::string>& names,
                                       const SynthesizedMotion& made, const FeatureTable& features);

/// A motion whose measured features are close to the requested ones. Slider values are corrected by
/// the deviations in up to eight trials, until no scaled feature deviates by 0.005 or more; the
/// best trial is returned.
SynthesizedMotion synthesize_with_features(const FittedInterface& interface,
                                           const Eigen::RowVectorXd& requested,
                                           const SynthesisContext& context,
                                           const FeatureTable& features);

/// The motion for requested parameters as in a stimulus: by `synthesize_with_features` for features
/// with the method `reach`, otherwise by `synthesize_at`.
SynthesizedMotion synthesize_for(const FittedInterface& interface,
                                 const Eigen::RowVectorXd& requested,
                                 const SynthesisContext& context, const FeatureTable& features);

}  // namespace mien::motion
