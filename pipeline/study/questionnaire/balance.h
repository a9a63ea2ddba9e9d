#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// How often something comes, of what comes least and most often.
struct CountRange {
  int least = 0;
  int most = 0;

  bool is_even() const { return least == most; }
};

/// How evenly sessions are laid out, of the trials that are analysed. What they are about is a
/// stimulus, or two as "a/b" whichever is left.
struct Balance {
  using PairCounts = std::map<std::pair<std::string, std::string>, int>;

  std::vector<std::string> subjects;   ///< in alphabetical order
  std::map<std::string, int> seen;     ///< how many participants see each subject
  PairCounts at_place;                 ///< subject and place among the analysed trials, from "1"
  PairCounts follows;                  ///< subject and the one right after it
  PairCounts together;                 ///< two subjects of one participant, the lesser name first
  std::map<std::string, int> flipped;  ///< item → participants with the high end at the left
  std::map<std::string, int> left;     ///< of pairs: how often the lesser name is left
  int most_places = 0;                 ///< analysed trials of the longest session
};

Balance balance_of(const Manifest& manifest, const std::vector<SessionPlan>& plans);

/// Least and most over all that could have come, those that never did included.
CountRange seen_range(const Balance& balance);
CountRange place_range(const Balance& balance);
CountRange follows_range(const Balance& balance);
CountRange together_range(const Balance& balance);
CountRange flipped_range(const Balance& balance);
CountRange left_range(const Balance& balance);

/// What is balanced and what cannot be with so many participants, a sentence each.
std::vector<std::string> balance_sentences(const Manifest& manifest, const Balance& balance,
                                           int participants);

/// The columns of the two tables.
extern const TableForm balance_form;
extern const TableForm plans_form;

/// All counts.
std::string balance_csv(const Balance& balance);

/// Every trial of every plan, one a row.
std::string plans_csv(const std::vector<SessionPlan>& plans);

}  // namespace mien::pipeline
