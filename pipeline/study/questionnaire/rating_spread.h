#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/ratings/answers/answers.h"

namespace mien::pipeline {

/// Standard deviations of the variance components of ratings, in points of the scale: participants
/// (response bias), stimuli, and the residual; and of the differences between participants in a
/// cell of the design (a combination of levels of the factors), which spread_of leaves in the
/// residual.
struct RatingSpread {
  double participant = 0.5;
  double stimulus = 0.5;
  double residual = 0.8;
  double participant_by_cell = 0.0;
};

/// A rating with the indices of its participant and stimulus.
struct CrossedRating {
  int participant = 0;
  int stimulus = 0;
  double value = 0.0;
};

/// Estimates variance components from ratings on one scale, by an analysis of variance with two
/// crossed random factors without repetition. Data may be unbalanced (method 1 of Henderson 1953).
/// Negative estimates become 0. Throws Error for fewer than two participants or stimuli, for fewer
/// ratings than participants and stimuli together, or if participant and stimulus effects are
/// confounded.
RatingSpread spread_of(const std::vector<CrossedRating>& ratings);

/// The variance components of the ratings on one scale.
struct ScaleSpread {
  std::string scale;  ///< id
  RatingSpread spread;
};

/// Estimates variance components scale by scale, in the order in which the scales first occur.
/// Repeated ratings of a stimulus by a participant are averaged first. Throws Error also for
/// answers that are means over participants.
std::vector<ScaleSpread> spreads_of(const Answers& answers);

}  // namespace mien::pipeline
