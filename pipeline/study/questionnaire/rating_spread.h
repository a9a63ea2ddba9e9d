#pragma once

#include <vector>

#include "pipeline/manifest/ratings/answers/answers.h"

namespace mien::pipeline {

/// Standard deviations of ratings, in points of the scale: of participants who lean to one end, of
/// stimuli that differ, and of what is left.
struct RatingSpread {
  double participant = 0.5;
  double stimulus = 0.5;
  double residual = 0.8;
};

/// One rating, by the numbers of who gave it and of what it is about.
struct CrossedRating {
  int participant = 0;
  int stimulus = 0;
  double value = 0.0;
};

/// From ratings on one scale, by the analysis of variance of two crossed random factors without
/// repetition; participants may have rated a part of the stimuli each (method 1 of Henderson 1953).
/// A part that comes out below 0 is 0. Throws Error with fewer than two participants or stimuli, or
/// where what participants and stimuli do cannot be told apart.
RatingSpread spread_of(const std::vector<CrossedRating>& ratings);

/// The same over all scales: the mean of the variances, scale by scale. Ratings that somebody gave
/// twice count with their mean.
RatingSpread spread_of(const Answers& answers);

}  // namespace mien::pipeline
