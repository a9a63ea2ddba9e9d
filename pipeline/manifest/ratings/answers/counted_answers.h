#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// Whether a row is an answer on a scale, and not a choice of an emotion, a choice from a pair or
/// an attention check.
bool is_on_scale(const AnswerRow& row);

/// The ratings in a table of answer rows (answer_row.h), converted to the tidy table participant,
/// stimulus, scale, value, rt_ms, comment, simulated. Fields keep their positions in the source
/// file.
struct CountedAnswers {
  CsvTable table;
  std::vector<std::string> notes;  ///< sentences about separated and excluded participants
  std::vector<Fault> warnings;     ///< about former names of columns
};

/// Returns the ratings, except those of practice, warm-up, checks and repeated stimuli, empty
/// answers, choices (of an emotion or from a pair), and every answer of a participant whom the
/// default AttentionRule excludes. Throws Faults as answer_rows does and for values that contradict
/// their raw answers, and Error if nothing remains.
CountedAnswers counted_answers(const CsvTable& answer_rows, const ScaleSet& scales);

/// Returns a fault for each answer on a scale whose value contradicts its raw answer, taking the
/// side of the poles into account. Whether a slider or a number of points was used is inferred from
/// the rows: it is the form that most of them agree with. If not even half of them agree with one
/// form, no faults are returned.
std::vector<Fault> contradicted_values(const std::vector<AnswerRow>& rows, const ScaleSet& scales);

/// The rule by which inattentive participants are excluded.
struct AttentionRule {
  /// Participants who fail more checks are excluded; one failure may be an oversight.
  int max_failed_checks = 1;
};

/// The number of a participant's attention checks and of those passed.
struct Attention {
  std::string participant;
  int checks = 0;  ///< answered checks that have an expected answer, except in practice
  int passed = 0;
  bool is_excluded = false;
};

/// Returns the attention checks of each participant, in the order of the rows. A participant
/// without checks is not excluded.
std::vector<Attention> attention_of(const std::vector<AnswerRow>& rows,
                                    const AttentionRule& rule = {});

/// Returns the rule as a plain sentence.
std::string to_sentence(const AttentionRule& rule);

}  // namespace mien::pipeline
