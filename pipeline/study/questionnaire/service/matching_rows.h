#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/study/questionnaire/service/record.h"

namespace mien::pipeline {

/// A completed matching trial, real or simulated.
struct MatchedTrial {
  std::string participant;
  std::string session;  ///< browser session; empty for simulated trials
  std::string design;   ///< design_hash
  Trial trial;
  MatchingRecord match;
  double limit_s = 0.0;      ///< seconds allowed for a match
  double threshold_m = 0.0;  ///< D below which motions match, metres
  bool simulated = false;
};

/// The columns of trials.csv and changes.csv.
extern const TableForm matching_trials_form;
extern const TableForm matching_changes_form;

/// CSV with a row for each trial except practice, as read by `mien study evaluate`.
std::string matching_trials_csv(const std::vector<MatchedTrial>& trials);

/// CSV with a row for each change, including those in practice.
std::string matching_changes_csv(const std::vector<MatchedTrial>& trials);

}  // namespace mien::pipeline
