#pragma once

#include <vector>

#include "pipeline/study/adaptive/next_films.h"

namespace mien::pipeline {

/// What a round of films has brought on one scale. All numbers but counts are NaN where fewer than
/// three films were rated before, or, of the first round, in it.
struct ScaleRound {
  int films = 0;
  int answers = 0;
  /// Standard deviation of the expected ratings after the round: root mean square over all
  /// candidates, in points.
  double deviation = 0.0;
  /// The mean ratings of the round's films, predicted from the rounds before; in the first round,
  /// each from the others (left_out_predictions).
  double error = 0.0;  ///< root mean square, in points
  /// 1 − sum of squared errors / sum of squared differences from the mean of the films from which
  /// is predicted: 0 if the prediction is no better than that mean.
  double explained = 0.0;
  double covered = 0.0;  ///< share of the films within their predicted 90 % intervals
};

/// A round of films.
struct FilmRound {
  int number = 1;
  int films = 0;    ///< number of different films
  int answers = 0;  ///< over all scales
  std::vector<ScaleRound> scales;
  double explained = 0.0;  ///< mean over the scales
  double covered = 0.0;    ///< mean over the scales
};

/// The rounds of the rated films, in order. What is known after each is determined as if nothing
/// had been rated later, by the process by which the next films are chosen; the variance of an
/// answer is that of all answers.
std::vector<FilmRound> film_rounds(const std::vector<FilmCandidate>& candidates,
                                   const std::vector<RatedFilms>& rated);

}  // namespace mien::pipeline
