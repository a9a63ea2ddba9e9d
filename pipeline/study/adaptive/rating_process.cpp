#include "pipeline/study/adaptive/rating_process.h"

#include <numeric>

#include <fmt/format.h>

#include "motion/error.h"

namespace mien::pipeline {

using Eigen::Index;
using Eigen::MatrixXd;

MatrixXd places_of(const std::vector<FilmCandidate>& candidates) {
  MatrixXd places(static_cast<Index>(candidates.size()), candidates.front().place.size());
  for (std::size_t c = 0; c < candidates.size(); ++c)
    places.row(static_cast<Index>(c)) = candidates[c].place;
  return places;
}

RatedFilms films_among(const RatedFilms& rated, const std::vector<Index>& films) {
  RatedFilms some{.scale = rated.scale,
                  .places = rated.places(films, Eigen::all),
                  .mean = rated.mean(films),
                  .answers = rated.answers(films),
                  .answer_variance = rated.answer_variance,
                  .ids = {},
                  .rounds = {}};
  for (const Index film : films) {
    const auto f = static_cast<std::size_t>(film);
    if (!rated.ids.empty()) some.ids.push_back(rated.ids[f]);
    if (!rated.rounds.empty()) some.rounds.push_back(rated.rounds[f]);
  }
  return some;
}

std::vector<std::vector<int>> one_family(Index parameters) {
  std::vector<int> columns(static_cast<std::size_t>(parameters));
  std::iota(columns.begin(), columns.end(), 0);
  return {columns};
}

GaussianProcess rating_process(const RatedFilms& rated, const Standardisation& by) {
  const Index count = rated.mean.size();
  if (count < fewest_rated)
    throw Error(fmt::format("only {} films are rated on {}", count, rated.scale),
                "rate three films or more before the next are chosen");
  GroupedObservations observations;
  observations.predictors = by.of(rated.places);
  observations.values = rated.mean;
  observations.noise_variance = rated.answer_variance * rated.answers.cast<double>().cwiseInverse();
  observations.group.resize(static_cast<std::size_t>(count));
  std::iota(observations.group.begin(), observations.group.end(), 0);
  return fit_process(one_family(rated.places.cols()), observations);
}

}  // namespace mien::pipeline
