#include "pipeline/study/chains/experiment/chain_results.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "motion/text/excerpt.h"

namespace mien::pipeline {

namespace {

using Points = std::vector<std::vector<double>>;

/// Of order statistics, linear between them (Hyndman and Fan 1996, type 7).
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

double deviation_of(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / (n - 1.0));
}

DimensionSamples dimension_samples(ChainValues values) {
  DimensionSamples samples{.mean = chain_mean(values),
                           .r_hat = scale_reduction(values),
                           .effective = effective_sample_size(values)};
  std::vector<double> all;
  for (const std::vector<double>& chain : values) all.insert(all.end(), chain.begin(), chain.end());
  samples.deviation = deviation_of(all);
  std::ranges::sort(all);
  samples.low = quantile(all, 0.05);
  samples.median = quantile(all, 0.5);
  samples.high = quantile(all, 0.95);
  samples.values = std::move(values);
  return samples;
}

std::size_t steps_per_sweep(const ChainDesign& design) {
  return design.method == ChainMethod::gibbs ? design.dimensions.size() : 1;
}

WordSamples word_samples(const ChainDesign& design, const std::string& word,
                         const std::vector<Points>& chains, std::size_t discarded) {
  WordSamples samples{.word = word, .chains = static_cast<int>(chains.size())};
  for (std::size_t d = 0; d < design.dimensions.size(); ++d) {
    ChainValues values = chain_values(chains, d, steps_per_sweep(design), discarded);
    if (values.empty() || values.front().empty())
      throw Error(fmt::format("there are no samples of {}", motion::in_quotes(word)),
                  "collect more answers, or discard fewer sweeps");
    samples.samples = static_cast<int>(values.size() * values.front().size());
    samples.dimensions.push_back(dimension_samples(std::move(values)));
  }
  return samples;
}

/// Relative weights as shares.
void normalise(Points& points) {
  for (std::vector<double>& point : points) {
    const double sum = std::accumulate(point.begin(), point.end(), 0.0);
    for (double& value : point) value /= sum;
  }
}

std::vector<WordDistance> distances_of(const ChainResults& results) {
  std::vector<WordDistance> distances;
  for (std::size_t a = 0; a < results.words.size(); ++a)
    for (std::size_t b = a + 1; b < results.words.size(); ++b) {
      const WordSamples& first = results.words[a];
      const WordSamples& second = results.words[b];
      double squares = 0.0, standardised = 0.0;
      const std::size_t count = first.dimensions.size();
      for (std::size_t d = 0; d < count; ++d) {
        const DimensionSamples& x = first.dimensions[d];
        const DimensionSamples& y = second.dimensions[d];
        const double apart = x.mean.mean - y.mean.mean;
        const DimensionRange& range = results.design.space[d];
        squares += std::pow(apart / (range.high - range.low), 2);
        standardised +=
            2.0 * apart * apart / (x.deviation * x.deviation + y.deviation * y.deviation);
      }
      const auto n = static_cast<double>(count);
      distances.push_back(
          {first.word, second.word, std::sqrt(squares / n), std::sqrt(standardised / n)});
    }
  return distances;
}

}  // namespace

std::vector<double> WordSamples::prototype() const {
  std::vector<double> point;
  for (const DimensionSamples& dimension : dimensions) point.push_back(dimension.mean.mean);
  return point;
}

ChainResults chain_results(const ChainStudy& study, const ChainAnswers& answers,
                           const SampleChoice& choice) {
  ChainResults results{.design = study.design, .simulated = answers.simulated};
  results.paths = chain_paths(study, choice.across_participants, answers);
  if (study.dimensions.kind == motion::InterfaceKind::weights)
    for (ChainPath& path : results.paths) normalise(path.points);
  const std::size_t sweeps =
      static_cast<std::size_t>(study.design.steps) / steps_per_sweep(study.design);
  results.discarded = choice.discarded >= 0 ? choice.discarded : static_cast<int>(sweeps / 2);
  for (const std::string& word : study.design.words) {
    std::vector<Points> chains;
    for (const ChainPath& path : results.paths) {
      if (path.name.word != word) continue;
      if (path.is_complete || choice.across_participants)
        chains.push_back(path.points);
      else
        ++results.incomplete;
    }
    results.words.push_back(
        word_samples(study.design, word, chains, static_cast<std::size_t>(results.discarded)));
  }
  results.distances = distances_of(results);
  return results;
}

}  // namespace mien::pipeline
