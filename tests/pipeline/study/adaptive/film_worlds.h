#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "pipeline/base/statistics/named_random.h"
#include "pipeline/study/adaptive/next_films.h"

namespace mien::pipeline {

/// Examples at random places of a space of three parameters.
inline Eigen::MatrixXd world_places(int count, std::uint64_t seed) {
  return Eigen::MatrixXd::NullaryExpr(count, 3, [&](Eigen::Index i, Eigen::Index j) {
    return uniform(seed, "place/" + std::to_string(i) + "/" + std::to_string(j));
  });
}

/// What all people together would answer: a smooth function of the parameters, another in each
/// world.
inline double world_rating(const Eigen::RowVectorXd& place, std::uint64_t seed) {
  const auto of = [&](const char* name) { return normal(seed, name); };
  return 2.0 * of("a") * place[0] + std::sin(3.0 * place[1] + of("b")) + of("c") * place[2] +
         of("d") * place[0] * place[2];
}

/// Ratings of these candidates with answers whose standard deviation is `spread`. `own`: standard
/// deviation of what a film has that its parameters do not say.
inline RatedFilms world_films(const std::vector<FilmCandidate>& candidates,
                              const std::vector<std::size_t>& films, std::uint64_t seed,
                              double own = 0.0, double spread = 0.5, int answers = 10) {
  RatedFilms rated{.scale = "sad-happy",
                   .places = {},
                   .mean = {},
                   .answers = {},
                   .answer_variance = spread * spread,
                   .ids = {},
                   .rounds = {}};
  const auto count = static_cast<Eigen::Index>(films.size());
  rated.places.resize(count, 3);
  rated.mean.resize(count);
  rated.answers.setConstant(count, answers);
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::size_t film = films[static_cast<std::size_t>(i)];
    const std::string name = "film" + std::to_string(film);
    rated.places.row(i) = candidates[film].place;
    rated.mean[i] = world_rating(candidates[film].place, seed) + own * normal(seed, name + "/own") +
                    spread / std::sqrt(answers) * normal(seed, name + "/answers");
    rated.ids.push_back(name);
    rated.rounds.push_back(1);
  }
  return rated;
}

}  // namespace mien::pipeline
