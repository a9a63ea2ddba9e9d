#pragma once

#include <string>
#include <vector>

#include "pipeline/study/questionnaire/service/record.h"

namespace mien::pipeline {

/// A trial of matching that somebody, or nobody, has gone through.
struct MatchedTrial {
  std::string participant;
  std::string session;  ///< browser session; empty of simulated ones
  std::string design;
  Trial trial;
  MatchingRecord match;
  double limit_s = 0.0;      ///< seconds allowed
  double threshold_m = 0.0;  ///< D below which motions match, metres
  bool simulated = false;
};

/// A row a trial, as `mien study evaluate` reads it, without practice: participant, target,
/// interface, first_guess_d (m), time_s, success, simulated; and trial, d (of the last setting, m),
/// guess_s, attempt, session, design, limit_s and threshold_m (m) of the experiment.
std::string matching_trials_csv(const std::vector<MatchedTrial>& trials);

/// A row a change, practice included: participant, trial, target, interface, is_practice, attempt,
/// time_s (since the trial began), step, action, slider, value, d, simulated.
std::string matching_changes_csv(const std::vector<MatchedTrial>& trials);

}  // namespace mien::pipeline
