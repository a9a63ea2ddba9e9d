#include "pipeline/study/adaptive/next_films.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>

#include <boost/math/distributions/normal.hpp>
#include <fmt/format.h>

#include "motion/error.h"
#include "pipeline/base/statistics/named_random.h"
#include "pipeline/study/adaptive/rating_process.h"

namespace mien::pipeline {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

/// Weights, in hundredths, of `parts` examples: uniform on the simplex, rounded.
std::vector<int> random_hundredths(std::uint64_t seed, const std::string& name, std::size_t parts) {
  std::vector<double> cuts = {0.0, 1.0};
  for (std::size_t k = 1; k < parts; ++k)
    cuts.push_back(uniform(seed, fmt::format("{}/cut/{}", name, k)));
  std::ranges::sort(cuts);
  std::vector<int> hundredths;
  for (std::size_t k = 0; k < parts; ++k)
    hundredths.push_back(static_cast<int>(std::lround(100.0 * cuts[k + 1])) -
                         static_cast<int>(std::lround(100.0 * cuts[k])));
  return hundredths;
}

/// Distinct examples, chosen at random.
std::vector<Index> random_examples(std::uint64_t seed, const std::string& name, Index examples,
                                   std::size_t parts) {
  std::vector<Index> chosen;
  for (int draw = 0; chosen.size() < parts; ++draw) {
    const double where = uniform(seed, fmt::format("{}/example/{}", name, draw));
    const Index example =
        std::min(examples - 1, static_cast<Index>(where * static_cast<double>(examples)));
    if (std::ranges::find(chosen, example) == chosen.end()) chosen.push_back(example);
  }
  return chosen;
}

/// What is known of one scale at all candidates.
struct Knowledge {
  VectorXd mean;
  MatrixXd covariance;
  double noise = 0.0;      ///< variance of the mean answer to a new film about the functions
  double at_first = 0.0;   ///< sum of the variances before anything is chosen
  double best = 0.0;       ///< best expected rating of the films rated or chosen so far
  double direction = 1.0;  ///< −1: lowest is best

  double left() const { return covariance.trace(); }

  double expected_error() const {
    return std::sqrt(std::max(0.0, left()) / static_cast<double>(mean.size()));
  }

  double deviation_at(Index c) const { return std::sqrt(std::max(0.0, covariance(c, c))); }

  /// How much the sum of variances would fall, as a share of what it was at first.
  double share_learned(Index c) const {
    return at_first > 0.0 ? covariance.col(c).squaredNorm() / (covariance(c, c) + noise) / at_first
                          : 0.0;
  }

  double expected_improvement(Index c) const {
    const double above = direction * (mean[c] - best), deviation = deviation_at(c);
    if (deviation < 1e-12) return std::max(0.0, above);
    const boost::math::normal standard;
    const double z = above / deviation;
    return above * cdf(standard, z) + deviation * pdf(standard, z);
  }

  /// As if the film had been rated as expected.
  void choose(Index c) {
    const VectorXd column = covariance.col(c);
    covariance -= column * column.transpose() / (column[c] + noise);
    best = direction * std::max(direction * best, direction * mean[c]);
  }
};

Knowledge knowledge_of(const RatedFilms& rated, const MatrixXd& places, const Standardisation& by,
                       const NextOptions& options) {
  const GaussianProcess process = rating_process(rated, by);
  JointPrediction joint = jointly_predicted(process, places);
  Knowledge known{.mean = std::move(joint.mean), .covariance = std::move(joint.covariance)};
  known.noise = deviation_variance(process.parameters) + rated.answer_variance / options.answers;
  known.at_first = known.left();
  known.direction = options.aim.highest ? 1.0 : -1.0;
  known.best = known.direction *
               (known.direction * jointly_predicted(process, process.observations.predictors).mean)
                   .maxCoeff();
  return known;
}

/// What is known of any scale before anything is rated, in standard deviations of the films' mean
/// ratings.
Knowledge knowledge_before_ratings(const MatrixXd& places, const NextOptions& options) {
  constexpr double variance_of_mean = 1.0, answer_variance = 2.0;
  const auto families = one_family(places.cols());
  const ProcessParameters usual = usual_parameters(families.size(), 1.0);
  JointPrediction joint = prior_prediction(families, usual, places, variance_of_mean);
  Knowledge known{.mean = std::move(joint.mean), .covariance = std::move(joint.covariance)};
  known.noise = deviation_variance(usual) + answer_variance / options.answers;
  known.at_first = known.left();
  return known;
}

/// Marks the places that are not apart from a film at `place`.
void mark_near(const MatrixXd& places, const RowVectorXd& place, double apart,
               std::vector<bool>& marks) {
  const double least = apart * std::sqrt(static_cast<double>(places.cols()));
  for (Index c = 0; c < places.rows(); ++c)
    if ((places.row(c) - place).norm() < least) marks[static_cast<std::size_t>(c)] = true;
}

/// Whether each candidate is not apart from some film that is rated, on every scale.
std::vector<bool> rated_already(const MatrixXd& places, const std::vector<RatedFilms>& rated,
                                const Standardisation& by, double apart) {
  std::vector<bool> known(static_cast<std::size_t>(places.rows()), !rated.empty());
  for (const RatedFilms& scale : rated) {
    std::vector<bool> near(known.size());
    const MatrixXd films = by.of(scale.places);
    for (Index f = 0; f < films.rows(); ++f) mark_near(places, films.row(f), apart, near);
    for (std::size_t c = 0; c < known.size(); ++c) known[c] = known[c] && near[c];
  }
  return known;
}

}  // namespace

std::vector<FilmCandidate> film_candidates(const MatrixXd& examples, std::size_t count, bool blends,
                                           std::uint64_t seed) {
  std::vector<FilmCandidate> candidates;
  for (Index i = 0; i < examples.rows(); ++i)
    candidates.push_back({VectorXd::Unit(examples.rows(), i), examples.row(i)});
  if (!blends || examples.rows() < 2) return candidates;
  const std::size_t most_parts = examples.rows() == 2 ? 2 : 3;
  std::set<std::vector<double>> known;
  // Two examples have 99 blends only.
  for (std::size_t draw = 0; candidates.size() < count && draw < 20 * count; ++draw) {
    const std::string name = fmt::format("candidate/{}", draw);
    const std::size_t parts = uniform(seed, name + "/parts") < 0.5 ? 2 : most_parts;
    const std::vector<Index> chosen = random_examples(seed, name, examples.rows(), parts);
    const std::vector<int> hundredths = random_hundredths(seed, name, parts);
    if (std::ranges::count_if(hundredths, [](int part) { return part > 0; }) < 2) continue;
    FilmCandidate candidate{VectorXd::Zero(examples.rows()), {}};
    for (std::size_t k = 0; k < parts; ++k) candidate.weights[chosen[k]] = hundredths[k] / 100.0;
    if (!known.emplace(candidate.weights.begin(), candidate.weights.end()).second) continue;
    candidate.place = candidate.weights.transpose() * examples;
    candidates.push_back(std::move(candidate));
  }
  return candidates;
}

NextFilms next_films(const std::vector<FilmCandidate>& candidates,
                     const std::vector<RatedFilms>& rated, const NextOptions& options) {
  MatrixXd places = places_of(candidates);
  const Standardisation by = standardisation_of(places);
  places = by.of(places);
  std::vector<Knowledge> scales;
  const Knowledge* aimed = nullptr;
  scales.reserve(rated.size() + 1);
  for (const RatedFilms& scale : rated) {
    scales.push_back(knowledge_of(scale, places, by, options));
    if (scale.scale == options.aim.scale) aimed = &scales.back();
  }
  if (!options.aim.scale.empty() && aimed == nullptr)
    throw Error("no film is rated on " + options.aim.scale, "name a scale that has answers");
  std::vector<bool> taken = rated_already(places, rated, by, options.apart);
  if (options.planned.rows() > 0) {
    const MatrixXd planned = by.of(options.planned);
    for (Index f = 0; f < planned.rows(); ++f)
      mark_near(places, planned.row(f), options.apart, taken);
  }
  assert(options.available.empty() || options.available.size() == taken.size());
  for (std::size_t c = 0; c < options.available.size(); ++c)
    taken[c] = taken[c] || !options.available[c];
  const auto gain = [&](Index c) {
    if (aimed != nullptr) return aimed->expected_improvement(c);
    double share = 0.0;
    for (const Knowledge& scale : scales) share += scale.share_learned(c);
    return share / static_cast<double>(scales.size());
  };
  NextFilms next;
  const bool is_first = rated.empty();
  if (is_first) scales.push_back(knowledge_before_ratings(places, options));
  for (std::size_t s = 0; s < rated.size(); ++s) {
    const Knowledge& scale = scales[s];
    next.known_now.push_back(scale.expected_error());
    next.known.push_back({scale.mean, scale.covariance.diagonal().cwiseMax(0.0).cwiseSqrt()});
  }
  while (next.films.size() < options.films) {
    NextFilm best{.gain = -1.0};
    for (Index c = 0; c < places.rows(); ++c) {
      if (taken[static_cast<std::size_t>(c)]) continue;
      if (const double here = gain(c); here > best.gain)
        best = {.candidate = static_cast<std::size_t>(c), .gain = here};
    }
    if (best.gain < 0.0) break;
    const auto chosen = static_cast<Index>(best.candidate);
    for (Knowledge& scale : scales) {
      if (!is_first) {
        best.mean.push_back(scale.mean[chosen]);
        best.deviation.push_back(scale.deviation_at(chosen));
      }
      scale.choose(chosen);
    }
    mark_near(places, places.row(chosen), options.apart, taken);
    next.films.push_back(std::move(best));
  }
  if (next.films.empty())
    throw Error("every film that could be made is rated already, or nearly the same as one that is",
                "add examples, or stop here");
  for (std::size_t s = 0; s < rated.size(); ++s)
    next.known_then.push_back(scales[s].expected_error());
  return next;
}

}  // namespace mien::pipeline
