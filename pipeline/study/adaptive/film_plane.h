#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pipeline/base/statistics/gaussian_process.h"
#include "pipeline/study/adaptive/next_films.h"

namespace mien::pipeline {

/// The plane of the first two principal components of the candidates' parameters, which are
/// standardised. The sign of a component is that with which its largest loading is positive.
struct FilmPlane {
  Standardisation by;
  Eigen::MatrixX2d axes;  ///< loadings of the parameters; 0 for a component that does not exist
  std::array<double, 2> explained{};  ///< share of the variance of each component

  /// Positions of films with these parameters, one row each.
  Eigen::MatrixX2d at(const Eigen::MatrixXd& places) const { return by.of(places) * axes; }
};

FilmPlane film_plane(const std::vector<FilmCandidate>& candidates);

/// The parameters with the largest loadings on a component, at most three and at least half of the
/// largest: "+ lateral-swing, − step-length".
std::string component_text(const FilmPlane& plane, Eigen::Index component,
                           const std::vector<std::string>& parameters);

}  // namespace mien::pipeline
