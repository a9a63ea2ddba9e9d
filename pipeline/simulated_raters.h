#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/answers.h"
#include "pipeline/scales.h"

namespace mien::pipeline {

/// What simulated raters see of a motion.
enum StyleAxis : int {
  quickness,
  clearness,
  activeness,
  largeness,
  valence,
  arousal,
  tension,
  stability,
};

inline constexpr int style_axis_count = 8;

/// "quickness" … "stability".
std::string_view name_of(StyleAxis axis);

/// One number an axis: of a motion, how much of it is there (−1 … 1); of a scale, how much it
/// counts.
using StyleAxes = std::array<double, style_axis_count>;

struct StyledStimulus {
  std::string name;
  StyleAxes axes;
};

struct SimulatedRaters {
  int count = 14;
  std::uint64_t seed = 0;
  double noise = 0.22;          ///< standard deviation of one answer, share of half the range
  double gain_spread = 0.15;    ///< of the raters' sensitivity about 1
  double offset_spread = 0.06;  ///< of the raters' leaning towards one end
};

/// How a scale's answer follows from the axes: its loadings from the scales file, else those of the
/// built-in adjective pair of that id. Throws Error when there are neither.
StyleAxes loadings_of(const Scale& scale);

/// Answers that nobody gave: each rater answers, on each scale, the loadings' weighted sum of the
/// axes times his own gain plus his own offset plus noise, squashed into the scale's range and
/// rounded to a whole step where the range has whole ends. Every number depends on (seed, rater,
/// stimulus, scale) alone. The result is marked as simulated.
Answers simulate_answers(const std::vector<StyledStimulus>& stimuli, const ScaleSet& scales,
                         const SimulatedRaters& raters);

}  // namespace mien::pipeline
