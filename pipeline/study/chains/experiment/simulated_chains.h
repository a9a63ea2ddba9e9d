#pragma once

#include <map>
#include <string>
#include <vector>

#include "pipeline/study/chains/experiment/chain_study.h"
#include "pipeline/study/questionnaire/service/chain_rows.h"

namespace mien::pipeline {

/// What simulated people take a word for: a normal distribution over the space, truncated to its
/// ranges, without correlations.
struct WordTruth {
  std::vector<double> mean;       ///< one per dimension
  std::vector<double> deviation;  ///< standard deviation before truncation
};

/// The truth of each word by default: around the example of the same name or, if there is none,
/// around a random blend of examples; of modifications, around a random point of the ranges, at 0.8
/// of the range of the recipe of the same name. The standard deviation is 0.12 of each range.
std::map<std::string, WordTruth> usual_truth(const ChainStudy& study);

/// Answers of all participants, practice included, marked as simulated. With a slider, a person
/// chooses a value with the probability of the word's distribution given the other dimensions;
/// between two motions, by the ratio of their probabilities (Luce's rule). Across participants, all
/// of them take turns, one trial each, until their trials or the chains are complete.
std::vector<ChainAnswer> simulated_chains(const ChainStudy& study, bool across_participants,
                                          const std::map<std::string, WordTruth>& truth,
                                          double attention_pass_rate = 0.98);

}  // namespace mien::pipeline
