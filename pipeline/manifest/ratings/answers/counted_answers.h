#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// Whether a row is an answer on a scale: not which of a list of emotions, nor which of two, nor a
/// check.
bool is_on_scale(const AnswerRow& row);

/// The ratings in a table of answer rows (answer_row.h), as the tidy table participant, stimulus,
/// scale, value, rt_ms, comment, simulated that other answers come as; fields keep their places.
struct CountedAnswers {
  CsvTable table;
  std::vector<std::string> notes;  ///< sentences: what was left out
};

/// Passed over are practice, warm-up, checks, repeated stimuli, what was left empty, choices
/// (which emotion, which of two) and all of participants who are excluded by the usual
/// AttentionRule. Throws Faults as answer_rows and where a value is not what its raw answer gives,
/// and Error when nothing is left.
CountedAnswers counted_answers(const CsvTable& answer_rows, const ScaleSet& scales);

/// Answers on scales whose value is not what their raw answer gives, turned by the side of the
/// poles. Whether people answered on a slider or on so many points follows from the rows
/// themselves: it is what most of them agree with.
std::vector<Fault> contradicted_values(const std::vector<AnswerRow>& rows, const ScaleSet& scales);

/// Whose answers are left out for want of attention.
struct AttentionRule {
  int max_failed_checks =
      1;  ///< who fails more checks is left out: one may be missed by an oversight
};

/// A participant's attention checks: how many there were and how many were passed.
struct Attention {
  std::string participant;
  int checks = 0;  ///< those with an expected answer that were answered
  int passed = 0;
  bool is_excluded = false;
};

/// The attention checks of every participant, in the order of the rows. Without checks nobody is
/// excluded.
std::vector<Attention> attention_of(const std::vector<AnswerRow>& rows,
                                    const AttentionRule& rule = {});

/// The rule in a plain sentence.
std::string to_sentence(const AttentionRule& rule);

}  // namespace mien::pipeline
