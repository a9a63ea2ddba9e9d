#pragma once

#include <string>
#include <vector>

#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

/// A flag with the answer or, if `trial` is 0, the participant that it concerns.
struct ListedFlag {
  std::string participant;
  int trial = 0;
  std::string stimulus;  ///< empty for participants, like `against` and `item`
  std::string against;
  std::string item;
  QualityFlag flag;
  bool is_excluded = false;  ///< the analysis leaves out the answer or participant for this flag
};

/// A rule with what it flagged.
struct RuleCount {
  std::string rule;      ///< its key in manifests; empty: all rules together
  std::string bound;     ///< its value; empty for all rules together
  std::string words;     ///< what it flags
  int participants = 0;  ///< participants who are flagged or some of whose answers are
  int answers = 0;  ///< answers to analysed trials that are flagged or of a flagged participant
  bool is_excluded = false;  ///< the analysis leaves out what the rule flags
  bool is_examined = true;   ///< otherwise the numbers mean nothing
};

/// All flags, sorted by participant, those of the participant first, then by trial. Empty if no
/// quality rules are set.
std::vector<ListedFlag> listed_flags(const AnswerSet& answer_set, std::vector<AnswerRow> rows);

/// The rule of attention checks, each rule that is set, and all of them together. Empty if no
/// quality rules are set.
std::vector<RuleCount> rule_counts(const AnswerSet& answer_set, std::vector<AnswerRow> rows);

/// A sentence for each flagged participant, who is excluded or included; empty if no quality rules
/// are set.
std::vector<std::string> flagged_sentences(const AnswerSet& answer_set);

}  // namespace mien::pipeline
