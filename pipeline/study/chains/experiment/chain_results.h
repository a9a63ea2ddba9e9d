#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "pipeline/base/adaptive/chain_convergence.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/base/drawing/plot.h"
#include "pipeline/study/chains/experiment/chain_answers.h"
#include "pipeline/study/chains/experiment/sample_density.h"

namespace mien::pipeline {

/// The samples of a word in one dimension.
struct DimensionSamples {
  ChainMean mean;            ///< over the chains, with a 95 % interval by the t distribution
  double deviation;          ///< standard deviation of all samples
  double low, median, high;  ///< quantiles 0.05, 0.5 and 0.95 of all samples
  double r_hat;              ///< scale_reduction; NaN if unknown
  double effective;          ///< effective_sample_size; NaN if unknown
  ChainValues values;        ///< of each chain

  SampleDensity density(const DimensionRange& range) const;
};

/// The samples of a word.
struct WordSamples {
  std::string word;
  int chains = 0;     ///< number of chains that are used
  int samples = 0;    ///< of all chains, in each dimension
  int discarded = 0;  ///< sweeps at the beginning of each chain that are not samples
  std::vector<DimensionSamples> dimensions;

  /// The mean of the samples: what the word looks like.
  std::vector<double> prototype() const;
};

/// How far two words are from each other.
struct WordDistance {
  std::string first, second;
  double distance;      ///< root mean square over the dimensions, as a share of their ranges
  double standardised;  ///< the same in units of the samples' standard deviations within words
};

struct ChainResults {
  ChainDesign design;
  std::vector<ChainPath> paths;  ///< all chains
  std::vector<WordSamples> words;
  std::vector<WordDistance> distances;
  int incomplete = 0;  ///< chains that are left out, since they are not complete
  /// Participants who failed too many attention checks. Their own chains are left out; chains
  /// across participants have those of their answers that a server took before.
  std::vector<std::string> inattentive = {};
  bool simulated = false;

  const WordSamples& of(const std::string& word) const;
};

/// Which samples are used.
struct SampleChoice {
  /// Sweeps (or choices) at the beginning of each chain that are left out; −1: the first half of
  /// those that all chains of the word have.
  int discarded = -1;
  bool across_participants = false;
  int max_failed_checks = 1;  ///< participants who fail more are inattentive
};

/// A sample is the point at the end of a sweep over all dimensions (in Markov chain Monte Carlo,
/// after each choice). Weights of examples are divided by their sum. Incomplete chains are left out
/// unless chains go across participants, where all chains are cut to the length of the shortest of
/// the word. Throws Error if a word has no samples.
ChainResults chain_results(const ChainStudy& study, const ChainAnswers& answers,
                           const SampleChoice& choice);

/// samples.csv, prototypes.csv, densities.csv and distances.csv.
std::vector<WrittenTable> chain_tables(const ChainResults& results);

/// For each word a panel per dimension, with the chains over their sweeps; discarded ones are
/// pale.
Plot chains_plot(const ChainResults& results);

/// For each dimension the density of every word's samples and, of two or more dimensions, for each
/// word a map of the density of its samples in the plane in which all samples vary most.
Plot densities_plot(const ChainResults& results);

/// For each dimension the samples of every word, with prototypes and their intervals.
Plot prototypes_plot(const ChainResults& results);

}  // namespace mien::pipeline
