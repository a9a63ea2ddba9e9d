#pragma once

#include <vector>

#include <Eigen/Core>

#include "pipeline/base/statistics/gaussian_process.h"
#include "pipeline/study/adaptive/next_films.h"

namespace mien::pipeline {

/// Number of rated films below which nothing is predicted.
inline constexpr Eigen::Index fewest_rated = 3;

/// Parameters of the candidates, one row each.
Eigen::MatrixXd places_of(const std::vector<FilmCandidate>& candidates);

/// The films with these numbers.
RatedFilms films_among(const RatedFilms& rated, const std::vector<Eigen::Index>& films);

/// All parameters as one family of predictors (gaussian_process.h).
std::vector<std::vector<int>> one_family(Eigen::Index parameters);

/// The mean ratings on one scale as a Gaussian process of the films' parameters, standardised `by`
/// the candidates. Throws Error if fewer than `fewest_rated` films are rated.
GaussianProcess rating_process(const RatedFilms& rated, const Standardisation& by);

}  // namespace mien::pipeline
