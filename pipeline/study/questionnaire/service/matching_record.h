#pragma once

#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// Why a record is refused.
class RecordFault : public std::runtime_error {
 public:
  explicit RecordFault(const std::string& wrong) : runtime_error(wrong) {}
};

/// The properties of a matching experiment by which its records are checked.
struct MatchingFacts {
  double limit_s = 300.0;
  double threshold_m = 0.06;
  std::map<std::string, std::vector<std::string>> sliders;  ///< all sliders of each interface
};

/// Reads them from the member "matching" of experiment.json.
MatchingFacts matching_facts(const nlohmann::ordered_json& matching);

/// Slider positions, 0 to 1.
struct SliderSetting {
  std::vector<std::string> sliders;
  std::vector<double> values;  ///< as many
};

/// An action of a participant in a matching trial.
struct MatchingChange {
  double seconds = 0.0;  ///< since the trial began
  std::string step;      ///< "guess" or "adjust"
  std::string action;    ///< "move", "add", "remove", "guess", "match", "limit"
  std::string slider;    ///< of "move", "add" and "remove"
  std::optional<double> value;
  std::optional<double> d;  ///< D of the resulting motion, metres; none where it was not displayed
};

/// The record of a matching trial.
struct MatchingRecord {
  SliderSetting first, last;
  double first_guess_d = 0.0;  ///< metres
  double guess_s = 0.0;        ///< duration of the guess, seconds
  double d = 0.0;              ///< D of the last setting, metres
  double time_s = 0.0;         ///< from the guess to the match or the time limit, seconds
  bool success = false;
  int attempt = 1;  ///< more than 1: the page was reloaded and the trial restarted
  std::vector<MatchingChange> changes;
};

/// Throws RecordFault for missing, unknown or malformed members.
MatchingRecord read_matching_record(const nlohmann::json& text);

/// Throws RecordFault when a record is impossible for the trial: sliders that its interface does
/// not have, decreasing times, a success beyond the time limit or threshold, a failure before the
/// limit.
void check_matching_record(const MatchingFacts& facts, const Trial& trial,
                           const MatchingRecord& record);

}  // namespace mien::pipeline
