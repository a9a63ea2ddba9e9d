#pragma once

#include <cstddef>
#include <vector>

#include "pipeline/base/statistics/agreement.h"
#include "pipeline/study/results/gathered_answers.h"

namespace mien::pipeline {

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
