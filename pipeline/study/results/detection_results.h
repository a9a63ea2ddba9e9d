#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "pipeline/base/statistics/signal_detection.h"
#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

/// The sensitivity in some of the trials of a detection or same–different questionnaire.
struct DetectionResult {
  /// If set, only the answers of this participant.
  std::optional<std::size_t> person;
  /// If set, only the trials of this stimulus with the signal and, if `other` is set, of the pair
  /// of both. Noise trials: of yes–no all, of two-interval those of the pair, of same–different
  /// those that show one of the two stimuli twice.
  std::optional<std::size_t> stimulus;
  std::optional<std::size_t> other;
  DetectionCounts counts;
  Sensitivity sensitivity;

  /// Share of right answers, the mean of those to signal and to noise trials; NaN without either.
  double correct() const;
};

/// The sensitivities of a questionnaire of detection.
struct DetectionResults {
  std::vector<DetectionResult> rows;  ///< all answers; each participant; each stimulus or pair
  /// Mean of the participants' d′ and its 95 % interval (Student), for which participants, not
  /// answers, are independent; NaN with fewer than two participants.
  double mean_d = std::numeric_limits<double>::quiet_NaN();
  Interval95 mean_ends = {mean_d, mean_d};
  int people = 0;  ///< number of participants with signal and noise trials
};

/// The sensitivities by the method of the questionnaire's form (signal_detection.h); without rows
/// if there are no answers to detection.
DetectionResults detection_results(const AnswerSet& answer_set);

}  // namespace mien::pipeline
