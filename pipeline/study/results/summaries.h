#pragma once

#include <cstddef>
#include <vector>

#include "pipeline/base/statistics/agreement.h"
#include "pipeline/study/results/gathered_answers.h"

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
  std::vector<int> counts;  ///< of each place on the scale, low end first
};

/// Of all stimuli that were rated, by stimulus, then by scale.
std::vector<RatingSummary> summaries_of(const Gathered& gathered);

/// NaN of none.
double median_of(std::vector<double> values);

/// The places on a scale, from least to most, as many as `points`.
std::vector<double> places_of(const Scale& scale, int points);

/// The answers about each stimulus on one scale, with the person who gave them; in the order of
/// Gathered::ratings.
std::vector<std::vector<CountedRating>> by_stimulus(const Gathered& gathered, std::size_t scale);

/// How well people agree about the stimuli on one scale.
struct Reliability {
  std::size_t scale = 0;
  Intraclass intraclass;    ///< of all answers (agreement.h has the rule for missing cells)
  int complete_people = 0;  ///< who answered about every stimulus that anybody answered about
  double alpha = 0.0;       ///< Cronbach's, of these alone; NaN below two
};

/// Scale by scale. A person's further answers about the same stimulus count with their mean.
std::vector<Reliability> reliability_of(const Gathered& gathered);

}  // namespace mien::pipeline
