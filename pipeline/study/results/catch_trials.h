#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/statistics/correlation.h"
#include "pipeline/study/results/gathered_answers.h"

namespace mien::pipeline {

/// One question that a participant answered twice about the same, because the stimulus was shown a
/// second time (`questionnaire.catch`). Attention checks, which expect a certain answer, are none.
struct CatchAnswer {
  std::string participant;
  bool is_excluded = false;  ///< by the rule of the report: told, but in no summary of all
  std::string stimulus;
  std::string against;  ///< the other one of a pair, or the reference beside; or empty
  std::string item;
  int first_trial = 0;
  int second_trial = 0;
  std::string first;  ///< value in the scale's own range, chosen word, or chosen stimulus
  std::string second;
  std::optional<double> difference;  ///< second less first, on the scale; none of choices and words

  bool is_equal() const;
};

/// How alike the first and second answers of some are.
struct CatchSummary {
  std::string participant;  ///< empty: all who count
  std::string item;         ///< empty: all
  bool is_excluded = false;
  int answers = 0;  ///< that were given twice
  int equal = 0;
  double mean_difference = 0.0;  ///< mean of |second − first|, scale points; NaN without ratings
  Correlation retest;            ///< of first with second ratings; NaN where there are too few
};

/// By participant, then in the order of the second answers. A rating is paired with the one that
/// counts in its stead; what was not answered both times is passed over.
std::vector<CatchAnswer> catch_answers_of(const Gathered& gathered, std::vector<AnswerRow> rows);

/// Of all who count, of these by item where there are several, then of each participant; none
/// without answers.
std::vector<CatchSummary> catch_summaries_of(const std::vector<CatchAnswer>& answers);

}  // namespace mien::pipeline
