#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/statistics/correlation.h"
#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

/// A participant's two answers to a question about a stimulus that was shown twice
/// (`questionnaire.retest.repeat`). Attention checks are not included.
struct RetestAnswer {
  std::string participant;
  /// The participant is excluded from the analysis; the answers are listed, and summarised for the
  /// participant alone.
  bool is_excluded = false;
  std::string stimulus;
  std::string against;  ///< second stimulus of a pair, or the reference; may be empty
  std::string item;
  int first_trial = 0;
  int second_trial = 0;
  std::string first;   ///< first answer: value in the scale's own range, choice, or chosen stimulus
  std::string second;  ///< second answer
  std::optional<double> difference;  ///< second − first, scale units; only for ratings

  bool is_equal() const;
};

/// Test-retest agreement of a set of repeated answers.
struct RetestSummary {
  std::string participant;  ///< empty: all included participants
  std::string item;         ///< empty: all items
  bool is_excluded = false;
  int answers = 0;               ///< number of questions answered twice
  int equal = 0;                 ///< number with equal answers
  double mean_difference = 0.0;  ///< mean of |second − first|, scale units; NaN without ratings
  Correlation retest;            ///< between first and second ratings; NaN if there are too few
};

/// All repeated answers, sorted by participant, then in the order of the second answers. Questions
/// not answered both times, or whose first answer quality rules leave out, are omitted.
std::vector<RetestAnswer> retest_answers_of(const AnswerSet& answer_set,
                                            std::vector<AnswerRow> rows);

/// Summaries over all included participants, then by item if there are several, then for each
/// participant. Summaries without answers are omitted.
std::vector<RetestSummary> retest_summaries_of(const std::vector<RetestAnswer>& answers);

}  // namespace mien::pipeline
