#include "pipeline/study/adaptive/film_rounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "pipeline/study/adaptive/rating_process.h"

namespace mien::pipeline {

namespace {

using Eigen::Index;

constexpr double unknown_gain = std::numeric_limits<double>::quiet_NaN();
constexpr double quantile_of_90_percent = 1.6448536269514722;  ///< of the normal distribution

int round_of(const RatedFilms& rated, Index film) {
  return rated.rounds.empty() ? 1 : rated.rounds[static_cast<std::size_t>(film)];
}

std::vector<Index> films_with(const RatedFilms& rated, auto is_wanted) {
  std::vector<Index> films;
  for (Index f = 0; f < rated.mean.size(); ++f)
    if (is_wanted(round_of(rated, f))) films.push_back(f);
  return films;
}

std::optional<GaussianProcess> process_if_enough(const RatedFilms& rated,
                                                 const Standardisation& by) {
  if (rated.mean.size() < fewest_rated) return std::nullopt;
  return rating_process(rated, by);
}

double expected_deviation(const GaussianProcess& process, const Eigen::MatrixXd& places) {
  const double sum = jointly_predicted(process, places).covariance.trace();
  return std::sqrt(std::max(0.0, sum) / static_cast<double>(places.rows()));
}

/// Predictions of films' mean ratings, and the means of those from which they are predicted.
struct RoundPredictions {
  std::vector<ProcessPrediction> films;
  Eigen::VectorXd otherwise;
};

RoundPredictions each_from_others(const GaussianProcess& process) {
  const Eigen::VectorXd& values = process.observations.values;
  const auto others = static_cast<double>(values.size() - 1);
  return {left_out_predictions(process), (values.sum() - values.array()) / others};
}

RoundPredictions from_before(const GaussianProcess& process, const RatedFilms& films,
                             const Standardisation& by) {
  RoundPredictions result;
  const Eigen::MatrixXd places = by.of(films.places);
  for (Index f = 0; f < places.rows(); ++f) {
    ProcessPrediction film = predicted(process, places.row(f));
    film.variance += films.answer_variance / films.answers[f];
    result.films.push_back(film);
  }
  result.otherwise.setConstant(places.rows(), process.observations.values.mean());
  return result;
}

void compare(const RoundPredictions& predictions, const Eigen::VectorXd& means,
             ScaleRound& result) {
  double squares = 0.0;
  int covered = 0;
  for (Index f = 0; f < means.size(); ++f) {
    const auto& [mean, variance] = predictions.films[static_cast<std::size_t>(f)];
    const double error = means[f] - mean;
    squares += error * error;
    covered += std::abs(error) <= quantile_of_90_percent * std::sqrt(variance) ? 1 : 0;
  }
  const auto count = static_cast<double>(means.size());
  const double squares_otherwise = (means - predictions.otherwise).squaredNorm();
  result.error = std::sqrt(squares / count);
  result.covered = covered / count;
  if (squares_otherwise > 0.0) result.explained = 1.0 - squares / squares_otherwise;
}

ScaleRound scale_round(const RatedFilms& rated, int number, const Eigen::MatrixXd& places,
                       const Standardisation& by) {
  ScaleRound result{.deviation = unknown_gain,
                    .error = unknown_gain,
                    .explained = unknown_gain,
                    .covered = unknown_gain};
  const RatedFilms now =
      films_among(rated, films_with(rated, [&](int round) { return round == number; }));
  const RatedFilms before =
      films_among(rated, films_with(rated, [&](int round) { return round < number; }));
  const RatedFilms so_far =
      films_among(rated, films_with(rated, [&](int round) { return round <= number; }));
  result.films = static_cast<int>(now.mean.size());
  result.answers = now.answers.sum();
  const auto after = process_if_enough(so_far, by);
  if (after) result.deviation = expected_deviation(*after, places);
  if (result.films == 0) return result;
  if (before.mean.size() == 0) {
    if (after) compare(each_from_others(*after), now.mean, result);
  } else if (const auto known = process_if_enough(before, by)) {
    compare(from_before(*known, now, by), now.mean, result);
  }
  return result;
}

/// The mean over the scales on which there is a value; NaN if there is none.
double mean_over(const std::vector<ScaleRound>& scales, double ScaleRound::*value) {
  double sum = 0.0;
  int count = 0;
  for (const ScaleRound& scale : scales) {
    if (std::isnan(scale.*value)) continue;
    sum += scale.*value;
    ++count;
  }
  return count > 0 ? sum / count : unknown_gain;
}

int films_of(const std::vector<RatedFilms>& rated, int number) {
  std::set<std::string> ids;
  int most = 0;
  for (const RatedFilms& scale : rated) {
    const std::vector<Index> films = films_with(scale, [&](int round) { return round == number; });
    most = std::max(most, static_cast<int>(films.size()));
    if (scale.ids.empty()) continue;
    for (const Index film : films) ids.insert(scale.ids[static_cast<std::size_t>(film)]);
  }
  return std::max(most, static_cast<int>(ids.size()));
}

}  // namespace

std::vector<FilmRound> film_rounds(const std::vector<FilmCandidate>& candidates,
                                   const std::vector<RatedFilms>& rated) {
  Eigen::MatrixXd places = places_of(candidates);
  const Standardisation by = standardisation_of(places);
  places = by.of(places);
  std::set<int> numbers;
  for (const RatedFilms& scale : rated)
    for (Index f = 0; f < scale.mean.size(); ++f) numbers.insert(round_of(scale, f));
  std::vector<FilmRound> rounds;
  for (const int number : numbers) {
    FilmRound round{.number = number, .films = films_of(rated, number)};
    for (const RatedFilms& scale : rated) {
      round.scales.push_back(scale_round(scale, number, places, by));
      round.answers += round.scales.back().answers;
    }
    round.explained = mean_over(round.scales, &ScaleRound::explained);
    round.covered = mean_over(round.scales, &ScaleRound::covered);
    rounds.push_back(std::move(round));
  }
  return rounds;
}

}  // namespace mien::pipeline
