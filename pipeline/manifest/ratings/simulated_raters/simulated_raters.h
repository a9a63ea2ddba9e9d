#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "motion/skeleton/example.h"
#include "pipeline/manifest/ratings/answers/answers.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// The impressions from which simulated ratings are computed, in the order of `StyleProfile`.
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

/// One value in (−1, 1) per impression.
using StyleProfile = std::array<double, style_impression_count>;

/// A motion and the impressions that it makes on simulated raters.
struct StyledStimulus {
  std::string name;
  StyleProfile profile;
};

struct SimulatedRaters {
  int count = 14;
  std::uint64_t seed = 0;
  double noise = 0.22;          ///< standard deviation of an answer, as a share of half the range;
                                ///< larger on the built-in pairs about which raters disagree
  double gain_spread = 0.15;    ///< standard deviation of the raters' sensitivity, whose mean is 1
  double offset_spread = 0.06;  ///< standard deviation of the raters' bias, as a share of half
                                ///< the range
};

/// Returns the weights of the impressions for a scale: its loadings in the scales file, otherwise
/// those of the built-in adjective pair with the same id. Throws Error if there are neither.
StyleProfile loadings_of(const Scale& scale);

/// Whether loadings_of has weights for a scale.
bool has_loadings(const Scale& scale);

/// Returns simulated answers. The weighted sum of the impressions is multiplied by 1.2 and by the
/// gain of the rater on the scale, and limited by tanh; the offset of the rater on the scale and
/// the noise of the answer are added, and the result is clamped to the scale's range and, if the
/// ends of the range are integers, rounded to an integer. Every random number depends only on
/// (seed, rater, stimulus, scale). On some of the built-in pairs, raters are neutral or disagree,
/// so that a study has scales to remove. The result is marked as simulated.
Answers simulate_answers(const std::vector<StyledStimulus>& stimuli, const ScaleSet& scales,
                         const SimulatedRaters& raters);

/// Returns the impressions that motions make on simulated raters. Each measure
/// (motion/measures/features/motion_measures.h) is standardized over the set (a spread below the
/// visible minimum is replaced by that minimum), and the measures are summed with the loadings
/// listed in the source. An impression is the tanh of 0.6 times its sum. For a set of one motion,
/// all values are 0.
std::vector<StyledStimulus> measured_profiles(const motion::ExampleSet& set);

}  // namespace mien::pipeline
