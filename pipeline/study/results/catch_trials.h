#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/statistics/correlation.h"
#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

/// A participant's two answers to a question about a stimulus that was shown twice
/// (`questionnaire.catch`). Attention checks are not included.
struct CatchAnswer {
  std::string participant;
  bool is_excluded = false;  ///< by the attention rule: listed, but left out of summaries
  std::string stimulus;
  std::string against;  ///< the second of a pair, or the reference; or empty
  std::string item;
  int first_trial = 0;
  int second_trial = 0;
  std::string first;  ///< value in the scale's own range, chosen word, or chosen stimulus
  std::string second;
  std::optional<double> difference;  ///< second − first, scale points; none for choices and words

  bool is_equal() const;
};

/// Test-retest agreement of a set of repeated answers.
struct CatchSummary {
  std::string participant;  ///< empty: all included participants
  std::string item;         ///< empty: all
  bool is_excluded = false;
  int answers = 0;  ///< questions answered twice
  int equal = 0;
  double mean_difference = 0.0;  ///< mean of |second − first|, scale points; NaN without ratings
  Correlation retest;            ///< of first with second ratings; NaN where there are too few
};

/// Repeated answers by participant, then in the order of the second answers. Questions not answered
/// both times are left out.
std::vector<CatchAnswer> catch_answers_of(const AnswerSet& answer_set, std::vector<AnswerRow> rows);

/// Summaries of all included participants, of these by item where there are several, then of each
/// participant. Those without answers are left out.
std::vector<CatchSummary> catch_summaries_of(const std::vector<CatchAnswer>& answers);

}  // namespace mien::pipeline
