#pragma once

#include <cstddef>
#include <vector>

#include "pipeline/base/statistics/agreement.h"
#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

/// The answers about one stimulus on one scale.
struct RatingSummary {
  std::size_t stimulus = 0;
  std::size_t scale = 0;
  int answers = 0;
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation (n − 1); NaN of one answer
  double low = 0.0;        ///< 95 % interval of the mean (Student); NaN of one answer
  double high = 0.0;
  double median = 0.0;
  std::vector<int> counts;  ///< of each point of the scale, low end first
};

/// Summaries of all rated stimuli, by stimulus, then by scale.
std::vector<RatingSummary> summaries_of(const AnswerSet& answer_set);

/// The median; NaN without values.
double median_of(std::vector<double> values);

/// The values of a scale's points, from least to most.
std::vector<double> scale_points(const Scale& scale, int points);

/// The ratings on one scale by stimulus, in the order of AnswerSet::ratings.
std::vector<std::vector<AnalysedRating>> ratings_by_stimulus(const AnswerSet& answer_set,
                                                             std::size_t scale);

/// Inter-rater reliability on one scale.
struct Reliability {
  std::size_t scale = 0;
  Intraclass intraclass;    ///< of all answers (agreement.h has the rule for missing cells)
  int complete_people = 0;  ///< participants who rated every rated stimulus
  double alpha = 0.0;       ///< Cronbach's alpha of these participants; NaN for fewer than two
};

/// The reliability of each scale. Repeated ratings by a participant are averaged.
std::vector<Reliability> reliability_of(const AnswerSet& answer_set);

}  // namespace mien::pipeline
