#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/adaptive/psychometric_bootstrap.h"
#include "pipeline/base/statistics/signal_detection.h"
#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

/// The psychometric function of a participant, or of all answers together. Levels are those of the
/// factor, also where lower ones are easier; the function is one of their ease (TrackProcedure).
struct ThresholdEstimate {
  std::optional<std::size_t> person;  ///< unset: all answers
  std::vector<LevelCount> counts;     ///< by level, from the hardest
  PsychometricFit fit;                ///< of the ease of levels
  double threshold;                   ///< NaN if the answers do not determine it
  IntervalEnds threshold_ends;        ///< 95 %, bootstrap
  double slope;                       ///< of positive answers by ease at the threshold
  IntervalEnds slope_ends;            ///< 95 %, bootstrap
  double deviance_p;
  /// QUEST+ only, otherwise NaN: mean of the posterior distribution of the threshold, and its 95 %
  /// credible interval. The mean is NaN if the interval reaches an end of the levels.
  double quest_mean;
  IntervalEnds quest_ends;
  double reversal_mean;  ///< staircases only, otherwise NaN: mean over the estimates of tracks

  int trials() const;
};

/// A trial of a track.
struct TrackPoint {
  int trial = 0;  ///< number in the session
  double level = 0.0;
  bool is_positive = false;
  bool is_reversal = false;  ///< of staircases
};

/// A track of a participant. It has all answers, also those that quality rules flag: its levels
/// follow from them.
struct TrackResult {
  std::size_t person = 0;
  int track = 0;
  std::vector<TrackPoint> points;
  /// Of staircases: the mean level of the reversals after the first two; otherwise NaN.
  double reversal_mean = std::numeric_limits<double>::quiet_NaN();
  double reversal_deviation = std::numeric_limits<double>::quiet_NaN();
  int reversals = 0;  ///< all of the track
};

/// The mean over participants of one kind of estimate of their thresholds.
struct GroupThreshold {
  const char* estimate = "";  ///< fit, quest or reversals
  int people = 0;             ///< those who have such an estimate
  int all = 0;                ///< those who answered
  double mean;                ///< NaN with fewer than two, like the following
  double deviation;           ///< standard deviation over participants
  Interval95 ends;            ///< 95 % interval of the mean (Student)
};

/// The thresholds of a questionnaire with adaptive trials.
struct ThresholdResults {
  std::vector<ThresholdEstimate> estimates;  ///< of all answers, then of each participant
  std::vector<TrackResult> tracks;
  std::vector<GroupThreshold> groups;  ///< by the fits, then by the estimates of the procedure
};

/// Reversals at the beginning of a staircase that its estimate leaves out.
inline constexpr int left_out_reversals = 2;

/// The fitted model: logistic, with the rates that threshold_sentences state.
PsychometricModel threshold_model(const TrialForm& form);

/// The thresholds; without estimates if the trials were not adaptive. The bootstrap of each
/// estimate has its own stream of random numbers, so that the same answers give the same results.
ThresholdResults threshold_results(const AnswerSet& answer_set);

/// Why there is no threshold; empty if there is one.
std::string threshold_remark(const ThresholdEstimate& estimate);

}  // namespace mien::pipeline
