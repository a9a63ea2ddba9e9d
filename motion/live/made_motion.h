#pragma once

#include <vector>

#include <Eigen/Core>

#include "motion/gait/foot_plant.h"
#include "motion/interpolation/interpolation.h"
#include "motion/live/slider_interface.h"
#include "motion/measures/features/feature_scale.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

/// What motions are made of, and how: everything but where the sliders stand.
struct Making {
  const ExampleSet& examples;  ///< with settled feet where feet are locked (settled_feet.h)
  const SynthesisOptions& how;
  double frames_per_second = 30.0;
};

/// A motion as a stimulus has it: feet locked where the options ask for it.
struct MadeMotion {
  Example motion;
  InterpolatedWeights found;
  std::vector<FootPlant> plants;  ///< as found before the lock
};

/// A blend; of a set that is not to be blended the example with the largest weight.
MadeMotion made_of_weights(const Eigen::VectorXd& weights, const Making& making);

/// What sliders make: exactly the blend that their method gives.
MadeMotion made_at(const FittedInterface& interface, const Eigen::RowVectorXd& settings,
                   const Making& making);

/// Features are measured of the motion, and a blend's are not quite what its weights sum up to.
struct FeatureTable {
  const FeatureScale& scale;    ///< of the examples
  const ParameterTable& table;  ///< in its place for a feature that the motion does not have
};

/// Feature parameters as a motion has them.
Eigen::RowVectorXd measured_parameters(const std::vector<std::string>& names,
                                       const MadeMotion& made, const FeatureTable& features);

/// The motion whose features, as measured, are nearest to those asked for: the settings are moved
/// by what was missed, eight times at the most, until no feature is missed by more than 0.005.
MadeMotion with_met_features(const FittedInterface& interface, const Eigen::RowVectorXd& wished,
                             const Making& making, const FeatureTable& features);

/// What sliders make as a stimulus that asks for the same would have it: features are met by trial
/// where the method is `reach`.
MadeMotion made_for(const FittedInterface& interface, const Eigen::RowVectorXd& wished,
                    const Making& making, const FeatureTable& features);

}  // namespace mien::motion
