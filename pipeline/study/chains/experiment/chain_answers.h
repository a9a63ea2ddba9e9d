#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/study/chains/experiment/chain_study.h"
#include "pipeline/study/questionnaire/service/chain_rows.h"

namespace mien::pipeline {

/// An answer of a file, without practice and attention checks.
struct ReadAnswer {
  ChainAnswer of;
  Place place;
};

/// The answers of an experiment.
struct ChainAnswers {
  std::vector<ReadAnswer> answers;
  std::map<std::string, int> failed_checks;  ///< number of failed attention checks by participant
  bool simulated = false;
};

/// Reads tables of answers (steps.csv, in the form of chain_steps_form). A row that occurs again in
/// another file is read once. Throws Error or Faults, with line and column, for malformed tables,
/// for words, dimensions or steps that the experiment does not have, for answers to another design,
/// for real answers beside simulated ones, and if there are no answers.
ChainAnswers read_chain_answers(const std::vector<std::filesystem::path>& files,
                                const ChainStudy& study);

/// A chain as its answers made it.
struct ChainPath {
  ChainName name;
  std::vector<std::vector<double>> points;  ///< after each complete step
  bool is_complete = false;
};

/// The chains that the answers make, sorted by word (in the order of the design), participant and
/// number. Unless chains go across participants, those of different participants are different
/// chains. Throws Faults, with line and column, where an answer does not follow from the answers
/// before: a step that is missing or was answered twice, or another point than that of the chain.
std::vector<ChainPath> chain_paths(const ChainStudy& study, bool across_participants,
                                   const ChainAnswers& answers);

}  // namespace mien::pipeline
