#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "motion/skeleton/example.h"
#include "pipeline/manifest/ratings/answers/answers.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// The impressions that simulated ratings are made of. Order of `StyleProfile`.
enum StyleImpression : int {
  Quickness,
  Clearness,
  Activeness,
  Largeness,
  Valence,
  Arousal,
  Tension,
  Stability,
};

inline constexpr int style_impression_count = 8;

/// One value in (−1, 1) an impression.
using StyleProfile = std::array<double, style_impression_count>;

/// A motion and what simulated raters see in it.
struct StyledStimulus {
  std::string name;
  StyleProfile profile;
};

struct SimulatedRaters {
  int count = 14;
  std::uint64_t seed = 0;
  double noise = 0.22;          ///< standard deviation of one answer, share of half the range
  double gain_spread = 0.15;    ///< of the raters' sensitivity about 1
  double offset_spread = 0.06;  ///< of the raters' leaning towards one end
};

/// How a scale's answer follows from the impressions: its loadings from the scales file, else those
/// of the built-in adjective pair of that id. Throws Error when there are neither.
StyleProfile loadings_of(const Scale& scale);

/// Simulated answers: each rater answers, on each scale, the loadings' weighted sum of the
/// impressions times his own gain plus his own offset plus noise, squashed into the scale's range
/// and rounded to a whole step where the range has whole ends. Every number depends on (seed,
/// rater, stimulus, scale) alone. On some of the built-in pairs raters are made to be neutral or of
/// different minds, so that a study has scales to remove. The result is marked as simulated.
Answers simulate_answers(const std::vector<StyledStimulus>& stimuli, const ScaleSet& scales,
                         const SimulatedRaters& raters);

/// What simulated raters see in motions: each measure (motion/measures/features/motion_measures.h)
/// is standardised over the set, a spread too small to be seen counting as one that just can, and
/// summed into the style impressions with the loadings listed in the source; tanh keeps the result
/// within −1 … 1. A set of one motion is all 0.
std::vector<StyledStimulus> measured_profiles(const motion::ExampleSet& set);

}  // namespace mien::pipeline
