#include "pipeline/study/adaptive/film_plane.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "pipeline/study/adaptive/rating_process.h"

namespace mien::pipeline {

FilmPlane film_plane(const std::vector<FilmCandidate>& candidates) {
  const Eigen::MatrixXd places = places_of(candidates);
  FilmPlane plane{.by = standardisation_of(places), .axes = {}};
  const Eigen::MatrixXd z = plane.by.of(places);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(z.transpose() * z);
  const Eigen::Index count = z.cols();
  plane.axes = Eigen::MatrixX2d::Zero(count, 2);
  const double all = solver.eigenvalues().sum();
  for (Eigen::Index component = 0; component < std::min<Eigen::Index>(2, count); ++component) {
    Eigen::VectorXd axis = solver.eigenvectors().col(count - 1 - component);
    // Of loadings that are equal but for rounding, the first.
    Eigen::Index largest = 0;
    while (std::abs(axis[largest]) < (1.0 - 1e-9) * axis.cwiseAbs().maxCoeff()) ++largest;
    if (axis[largest] < 0.0) axis = -axis;
    plane.axes.col(component) = axis;
    if (all > 0.0)
      plane.explained[static_cast<std::size_t>(component)] =
          std::max(0.0, solver.eigenvalues()[count - 1 - component]) / all;
  }
  return plane;
}

std::string component_text(const FilmPlane& plane, Eigen::Index component,
                           const std::vector<std::string>& parameters) {
  const Eigen::VectorXd loadings = plane.axes.col(component);
  std::vector<Eigen::Index> order(static_cast<std::size_t>(loadings.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::ranges::stable_sort(order, std::ranges::greater{},
                           [&](Eigen::Index p) { return std::abs(loadings[p]); });
  std::string text;
  int named = 0;
  for (const Eigen::Index p : order) {
    if (named == 3 || std::abs(loadings[p]) < 0.5 * std::abs(loadings[order.front()])) break;
    ++named;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", loadings[p] < 0.0 ? "−" : "+",
                        parameters[static_cast<std::size_t>(p)]);
  }
  return text;
}

}  // namespace mien::pipeline
