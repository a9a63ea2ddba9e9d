#pragma once

#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// Why a record is not taken.
class RecordFault : public std::runtime_error {
 public:
  explicit RecordFault(const std::string& wrong) : runtime_error(wrong) {}
};

/// What must be known of a matching experiment to understand what is given in it.
struct MatchingFacts {
  double limit_s = 300.0;
  double threshold_m = 0.06;
  std::map<std::string, std::vector<std::string>> sliders;  ///< by interface: all there can be
};

/// As experiment.json tells it in "matching".
MatchingFacts matching_facts(const nlohmann::ordered_json& matching);

/// Where sliders stand, 0 to 1.
struct SliderSetting {
  std::vector<std::string> sliders;
  std::vector<double> values;  ///< as many
};

/// Something that a participant did.
struct MatchingChange {
  double seconds = 0.0;  ///< since the trial began
  std::string step;      ///< "guess" or "adjust"
  std::string action;    ///< "move", "add", "remove", "guess", "match", "limit"
  std::string slider;    ///< of the first three
  std::optional<double> value;
  std::optional<double> d;  ///< of the motion that came of it, metres; none of what was not seen
};

/// A trial of matching as its page gives it.
struct MatchingRecord {
  SliderSetting first, last;
  double first_guess_d = 0.0;  ///< metres
  double guess_s = 0.0;        ///< that the guess took
  double d = 0.0;              ///< of the last setting, metres
  double time_s = 0.0;         ///< from the guess to the match, or to the limit
  bool success = false;
  int attempt = 1;  ///< more than 1: the page was loaded again meanwhile, and the trial begun anew
  std::vector<MatchingChange> changes;
};

/// Throws RecordFault as read_record does.
MatchingRecord read_matching_record(const nlohmann::json& text);

/// Throws RecordFault when that cannot have come of the trial: sliders that its interface does not
/// have, times that go back, a success beyond the limit or the threshold, a failure before.
void check_matching_record(const MatchingFacts& facts, const Trial& trial,
                           const MatchingRecord& record);

}  // namespace mien::pipeline
