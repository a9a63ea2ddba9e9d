#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/base/statistics/agreement.h"
#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

/// Statistics of the answers about one stimulus on one scale, in scale units.
struct RatingSummary {
  std::size_t stimulus = 0;
  std::size_t scale = 0;
  int answers = 0;  ///< number of answers
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation (n − 1); NaN for one answer
  double low = 0.0;        ///< 95 % confidence interval of the mean (Student); NaN for one answer
  double high = 0.0;
  double median = 0.0;
  std::vector<int> counts;  ///< number of answers at each point of the scale, low end first
};

/// Summaries of all rated stimuli, sorted by stimulus, then by scale.
std::vector<RatingSummary> summaries_of(const AnswerSet& answer_set);

/// The median; NaN if there are no values.
double median_of(std::vector<double> values);

/// The values of a scale's points in ascending order.
std::vector<double> scale_points(const Scale& scale, int points);

/// The ratings on one scale by stimulus, in the order of AnswerSet::ratings.
std::vector<std::vector<AnalysedRating>> ratings_by_stimulus(const AnswerSet& answer_set,
                                                             std::size_t scale);

/// Inter-rater reliability on one scale.
struct Reliability {
  std::size_t scale = 0;
  Intraclass intraclass;  ///< of all answers; missing answers are treated as agreement.h describes
  int complete_people = 0;  ///< participants who rated every rated stimulus
  double alpha = 0.0;       ///< Cronbach's alpha over these participants; NaN for fewer than two
  std::string remark = {};  ///< why there are none, or what they mean (agreement_remark)
};

/// The reliability of each scale. Repeated ratings by a participant are averaged.
std::vector<Reliability> reliability_of(const AnswerSet& answer_set);

}  // namespace mien::pipeline
