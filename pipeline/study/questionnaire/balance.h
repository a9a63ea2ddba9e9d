#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// The smallest and largest of a set of counts.
struct CountRange {
  int least = 0;
  int most = 0;

  bool is_uniform() const { return least == most; }
};

/// Counts over the analysed trials that show how balanced the session plans are. A subject is a
/// stimulus, or a pair written as "a/b" in alphabetical order.
struct Balance {
  using PairCounts = std::map<std::pair<std::string, std::string>, int>;

  std::vector<std::string> subjects;  ///< in alphabetical order
  std::map<std::string, int> seen;    ///< number of participants who see each subject
  PairCounts position_counts;    ///< by subject and position among the analysed trials, from "1"
  PairCounts succession_counts;  ///< by subject and its immediate successor
  PairCounts
      concurrence_counts;  ///< by two subjects seen by the same participant, in alphabetical order
  std::map<std::string, int>
      flipped;  ///< by item: number of participants with the high end at the left
  std::map<std::string, int>
      left;  ///< by pair: number of trials with the alphabetically first stimulus at the left
  PairCounts places;  ///< of sets, by stimulus and place in the set, from "1": number of trials
  /// By stimulus: number of trials in which it is shown twice. These are no subjects.
  std::map<std::string, int> same;
  int max_positions = 0;  ///< number of analysed trials of the longest session
};

Balance balance_of(const Manifest& manifest, const std::vector<SessionPlan>& plans);

// Ranges of these counts over all possible combinations, including those that never occur.
CountRange participant_range(const Balance& balance);
CountRange position_range(const Balance& balance);
CountRange succession_range(const Balance& balance);
CountRange concurrence_range(const Balance& balance);
CountRange flipped_range(const Balance& balance);
CountRange left_range(const Balance& balance);
CountRange place_range(const Balance& balance);
CountRange same_range(const Balance& balance);

/// Sentences that state what is balanced, and what cannot be balanced with that number of
/// participants.
std::vector<std::string> balance_sentences(const Manifest& manifest, const Balance& balance,
                                           int participants);

/// The columns of balance.csv and plans.csv.
extern const TableForm balance_form;
extern const TableForm plans_form;

/// All counts of a balance as CSV.
std::string balance_csv(const Balance& balance);

/// CSV with a row for each trial of each plan.
std::string plans_csv(const std::vector<SessionPlan>& plans);

}  // namespace mien::pipeline
