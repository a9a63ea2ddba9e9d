#pragma once

#include <vector>

#include "motion/skeleton/example.h"
#include "pipeline/manifest/ratings/simulated_raters/simulated_raters.h"

namespace mien::pipeline {

/// What simulated raters see in motions: each measure (motion/measures/features/motion_measures.h)
/// is standardised over the set, a spread too small to be seen counting as one that just can, and
/// summed into the style impressions with the loadings listed in the source; tanh keeps the result
/// within −1 … 1. A set of one motion is all 0.
std::vector<StyledStimulus> measured_profiles(const motion::ExampleSet& set);

}  // namespace mien::pipeline
