#include "pipeline/study/chains/experiment/chain_results.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/study/chains/experiment/sample_quantile.h"

namespace mien::pipeline {

namespace {

using Points = std::vector<std::vector<double>>;

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
  samples.low = quantile_of(all, 0.05);
  samples.median = quantile_of(all, 0.5);
  samples.high = quantile_of(all, 0.95);
  samples.values = std::move(values);
  return samples;
}

WordSamples word_samples(const ChainDesign& design, const std::string& word,
                         const std::vector<Points>& chains, int discarded) {
  WordSamples samples{.word = word, .chains = static_cast<int>(chains.size())};
  const std::size_t per_sweep = design.steps_per_sweep();
  samples.discarded =
      discarded >= 0 ? discarded : static_cast<int>(shortest_sweeps(chains, per_sweep) / 2);
  for (std::size_t d = 0; d < design.dimensions.size(); ++d) {
    ChainValues values =
        chain_values(chains, d, per_sweep, static_cast<std::size_t>(samples.discarded));
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

SampleDensity DimensionSamples::density(const DimensionRange& range) const {
  std::vector<double> all;
  for (const std::vector<double>& chain : values) all.insert(all.end(), chain.begin(), chain.end());
  return sample_density(all, effective, range);
}

std::vector<double> WordSamples::prototype() const {
  std::vector<double> point;
  for (const DimensionSamples& dimension : dimensions) point.push_back(dimension.mean.mean);
  return point;
}

const WordSamples& ChainResults::of(const std::string& word) const {
  return *std::ranges::find(words, word, &WordSamples::word);
}

ChainResults chain_results(const ChainStudy& study, const ChainAnswers& answers,
                           const SampleChoice& choice) {
  ChainResults results{.design = study.design, .simulated = answers.simulated};
  results.paths = chain_paths(study, choice.across_participants, answers);
  if (study.design.has_relative_values)
    for (ChainPath& path : results.paths) normalise(path.points);
  for (const auto& [participant, failed] : answers.failed_checks)
    if (failed > choice.max_failed_checks) results.inattentive.push_back(participant);
  if (!choice.across_participants)
    std::erase_if(results.paths, [&](const ChainPath& path) {
      return std::ranges::find(results.inattentive, path.name.participant) !=
             results.inattentive.end();
    });
  for (const std::string& word : study.design.words) {
    std::vector<Points> chains;
    for (const ChainPath& path : results.paths) {
      if (path.name.word != word) continue;
      if (path.is_complete || choice.across_participants)
        chains.push_back(path.points);
      else
        ++results.incomplete;
    }
    results.words.push_back(word_samples(study.design, word, chains, choice.discarded));
  }
  results.distances = distances_of(results);
  return results;
}

}  // namespace mien::pipeline
