#include <fmt/format.h>

#include "pipeline/study/chains/experiment/chain_results.h"
#include "pipeline/study/questionnaire/service/chain_rows.h"

namespace mien::pipeline {

namespace {

struct SampleRow {
  const ChainResults& results;
  const ChainPath& path;
  std::size_t step;
  std::size_t dimension;

  std::size_t sweep() const { return step / results.design.steps_per_sweep(); }
};

constexpr auto samples_columns = table_of<SampleRow>(
    "samples.csv", "step of a chain and dimension",
    {{"word", "", "id of the word", [](auto& r) { return r.path.name.word; }},
     {"participant", "", "participant of the chain; empty if it goes across participants",
      [](auto& r) { return r.path.name.participant; }},
     {"chain", "", "number of the chain, from 1", [](auto& r) { return r.path.name.chain; }},
     {"step", "", "step of the chain, from 0", [](auto& r) { return r.step; }},
     {"sweep", "", "sweep over the dimensions, from 0; of choices, the step",
      [](auto& r) { return r.sweep(); }},
     {"is_discarded", "0/1", "1: at the beginning of the chain, and not used",
      [](auto& r) {
        return static_cast<int>(r.sweep()) < r.results.of(r.path.name.word).discarded;
      }},
     {"dimension", "", "dimension of the space",
      [](auto& r) { return r.results.design.dimensions[r.dimension]; }},
     {"value", "of the dimension", "value after the step",
      [](auto& r) { return r.path.points[r.step][r.dimension]; }},
     {"simulated", "0/1", "1: simulated answers", [](auto& r) { return r.results.simulated; }}});

struct PrototypeRow {
  const ChainResults& results;
  const WordSamples& word;
  std::size_t dimension;

  const DimensionSamples& of() const { return word.dimensions[dimension]; }
};

constexpr auto prototypes_columns = table_of<PrototypeRow>(
    "prototypes.csv", "word and dimension",
    {{"word", "", "id of the word", [](auto& r) { return r.word.word; }},
     {"dimension", "", "dimension of the space",
      [](auto& r) { return r.results.design.dimensions[r.dimension]; }},
     {"mean", "of the dimension", "mean of the samples: the prototype",
      [](auto& r) { return r.of().mean.mean; }},
     {"low_95", "of the dimension",
      "lower end of the 95 % confidence interval of the mean, from the means of the "
      "chains by the t distribution; empty with one chain",
      [](auto& r) { return r.of().mean.ends.low; }},
     {"high_95", "of the dimension", "its upper end",
      [](auto& r) { return r.of().mean.ends.high; }},
     {"sd", "of the dimension", "standard deviation of the samples",
      [](auto& r) { return r.of().deviation; }},
     {"q05", "of the dimension", "quantile 0.05 of the samples",
      [](auto& r) { return r.of().low; }},
     {"median", "of the dimension", "median of the samples", [](auto& r) { return r.of().median; }},
     {"q95", "of the dimension", "quantile 0.95 of the samples",
      [](auto& r) { return r.of().high; }},
     {"range_low", "of the dimension", "lower end of the dimension",
      [](auto& r) { return r.results.design.space[r.dimension].low; }},
     {"range_high", "of the dimension", "its upper end",
      [](auto& r) { return r.results.design.space[r.dimension].high; }},
     {"chains", "", "number of chains", [](auto& r) { return r.word.chains; }},
     {"samples", "", "number of samples of all chains", [](auto& r) { return r.word.samples; }},
     {"r_hat", "",
      "potential scale reduction factor of the chains: near 1 if they agree, above 1.1 "
      "if they have not converged; empty if unknown",
      [](auto& r) { return r.of().r_hat; }},
     {"effective_samples", "",
      "number of independent samples that would determine the mean as well; "
      "empty if unknown",
      [](auto& r) { return r.of().effective; }},
     {"simulated", "0/1", "1: simulated answers", [](auto& r) { return r.results.simulated; }}});

struct DensityRow {
  const ChainResults& results;
  const std::string& word;
  std::size_t dimension;
  double value, density;
};

constexpr auto densities_columns = table_of<DensityRow>(
    "densities.csv", "word, dimension and value",
    {{"word", "", "id of the word", [](auto& r) { return r.word; }},
     {"dimension", "", "dimension of the space",
      [](auto& r) { return r.results.design.dimensions[r.dimension]; }},
     {"value", "of the dimension", "value of the dimension", [](auto& r) { return r.value; }},
     {"density", "",
      "probability density of the samples there (kernel estimate, reflected at the ends of the "
      "range)",
      [](auto& r) { return r.density; }},
     {"simulated", "0/1", "1: simulated answers", [](auto& r) { return r.results.simulated; }}});

std::vector<DensityRow> density_rows(const ChainResults& results) {
  std::vector<DensityRow> rows;
  for (const WordSamples& word : results.words)
    for (std::size_t d = 0; d < word.dimensions.size(); ++d) {
      const SampleDensity of = word.dimensions[d].density(results.design.space[d]);
      for (std::size_t i = 0; i < of.places.size(); ++i)
        rows.push_back({results, word.word, d, of.places[i], of.density[i]});
    }
  return rows;
}

struct DistanceRow {
  const ChainResults& results;
  const WordDistance& of;
};

constexpr auto distances_columns = table_of<DistanceRow>(
    "distances.csv", "pair of words",
    {{"first", "", "id of a word", [](auto& r) { return r.of.first; }},
     {"second", "", "id of the other word", [](auto& r) { return r.of.second; }},
     {"distance", "",
      "distance of the prototypes as a share of the dimensions' ranges (root mean "
      "square)",
      [](auto& r) { return r.of.distance; }},
     {"standardised", "",
      "the same in standard deviations of the samples within words; empty if "
      "these do not vary",
      [](auto& r) { return r.of.standardised; }},
     {"simulated", "0/1", "1: simulated answers", [](auto& r) { return r.results.simulated; }}});

}  // namespace

std::vector<WrittenTable> chain_tables(const ChainResults& results) {
  std::vector<SampleRow> samples;
  for (const ChainPath& path : results.paths)
    for (std::size_t step = 0; step < path.points.size(); ++step)
      for (std::size_t d = 0; d < results.design.dimensions.size(); ++d)
        samples.push_back({results, path, step, d});
  std::vector<PrototypeRow> prototypes;
  for (const WordSamples& word : results.words)
    for (std::size_t d = 0; d < word.dimensions.size(); ++d)
      prototypes.push_back({results, word, d});
  std::vector<DistanceRow> distances;
  for (const WordDistance& one : results.distances) distances.push_back({results, one});
  return {samples_columns.of(samples), prototypes_columns.of(prototypes),
          densities_columns.of(density_rows(results)), distances_columns.of(distances)};
}

}  // namespace mien::pipeline
