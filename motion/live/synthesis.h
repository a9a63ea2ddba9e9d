#pragma once

#include <vector>

#include <Eigen/Core>

#include "motion/gait/foot_plant.h"
#include "motion/interpolation/interpolation.h"
#include "motion/live/slider_interface.h"
#include "motion/measures/features/feature_scale.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

/// Examples and options of motion synthesis: everything but the slider values.
struct SynthesisContext {
  const ExampleSet& examples;  ///< with settled feet where feet are locked (settled_feet.h)
  const SynthesisOptions& how;
  double frames_per_second = 30.0;
};

/// A synthesized motion as in a stimulus: feet locked if the options say so.
struct SynthesizedMotion {
  Example motion;
  InterpolatedWeights found;
  std::vector<FootPlant> plants;  ///< as found before the lock
};

/// Synthesizes a blend; of a set that is not to be blended, the example with the largest weight.
SynthesizedMotion synthesize_from_weights(const Eigen::VectorXd& weights,
                                          const SynthesisContext& context);

/// Synthesizes the blend that the interface's method gives for slider values.
SynthesizedMotion synthesize_at(const FittedInterface& interface,
                                const Eigen::RowVectorXd& settings,
                                const SynthesisContext& context);

/// How feature parameters are measured: a blend's features differ from the weighted sum of the
/// examples'.
struct FeatureTable {
  const FeatureScale& scale;    ///< of the examples
  const ParameterTable& table;  ///< fallback for a feature that the motion does not have
};

/// Measured feature parameters of a motion.
Eigen::RowVectorXd measured_parameters(const std::vector<std::string>& names,
                                       const SynthesizedMotion& made, const FeatureTable& features);

/// The motion whose measured features are nearest to the requested ones: the slider values are
/// corrected by the deviations, at most eight times, until no feature deviates by more than 0.005.
SynthesizedMotion synthesize_with_features(const FittedInterface& interface,
                                           const Eigen::RowVectorXd& requested,
                                           const SynthesisContext& context,
                                           const FeatureTable& features);

/// The motion for requested parameters as in a stimulus: with features and the method `reach` by
/// synthesize_with_features, else by synthesize_at.
SynthesizedMotion synthesize_for(const FittedInterface& interface,
                                 const Eigen::RowVectorXd& requested,
                                 const SynthesisContext& context, const FeatureTable& features);

}  // namespace mien::motion
