#pragma once

#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// Thrown for an invalid record; `what()` gives the reason.
class RecordFault : public std::runtime_error {
 public:
  explicit RecordFault(const std::string& wrong) : runtime_error(wrong) {}
};

/// The properties of a matching experiment against which its records are checked.
struct MatchingFacts {
  double limit_s = 300.0;                                   ///< seconds allowed for a match
  double threshold_m = 0.06;                                ///< D below which motions match, metres
  std::map<std::string, std::vector<std::string>> sliders;  ///< all sliders of each interface
};

/// Reads these properties from the member "matching" of experiment.json.
MatchingFacts matching_facts(const nlohmann::ordered_json& matching);

/// Slider positions, 0 to 1.
struct SliderSetting {
  std::vector<std::string> sliders;
  std::vector<double> values;  ///< one per slider
};

/// An action of a participant in a matching trial.
struct MatchingChange {
  double seconds = 0.0;         ///< since the trial began
  std::string step;             ///< "guess" or "adjust"
  std::string action;           ///< "move", "add", "remove", "guess", "match", "limit"
  std::string slider;           ///< for "move", "add" and "remove"
  std::optional<double> value;  ///< new position of the slider, 0 to 1
  /// D of the resulting motion, metres; empty if that motion was not synthesized.
  std::optional<double> d;
};

/// The record of a matching trial.
struct MatchingRecord {
  SliderSetting first, last;   ///< the first guess and the final setting
  double first_guess_d = 0.0;  ///< metres
  double guess_s = 0.0;        ///< duration of the guess, seconds
  double d = 0.0;              ///< D of the final setting, metres
  double time_s = 0.0;         ///< from the guess to the match or the time limit, seconds
  bool success = false;
  int attempt = 1;  ///< greater than 1 if the page was reloaded and the trial restarted
  std::vector<MatchingChange> changes;
};

/// Parses a record. Throws RecordFault for missing, unknown or malformed members.
MatchingRecord read_matching_record(const nlohmann::json& text);

/// Throws RecordFault if a record is impossible for the trial: sliders that its interface does not
/// have or that appear twice in a setting, decreasing times of changes, an `attempt` below 1, a
/// success after the time limit or with D not below the threshold, or a failure more than one
/// second before the limit.
void check_matching_record(const MatchingFacts& facts, const Trial& trial,
                           const MatchingRecord& record);

}  // namespace mien::pipeline
