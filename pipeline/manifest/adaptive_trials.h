#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "motion/text/words.h"
#include "pipeline/base/documents/concerns.h"

namespace mien::pipeline {

/// How the level of the next trial of a track follows from the answers so far.
enum class AdaptiveMethod {
  quest,      ///< QUEST+ (Watson 2017): the level that is expected to tell the most
  staircase,  ///< n up, m down (Levitt 1971), with steps of two sizes (Kaernbach 1991)
};

/// Whether the signal is easier to notice at higher or at lower levels of the factor.
enum class LevelDirection { rising, falling };

/// The level with which a staircase begins.
enum class StaircaseStart { easiest, middle, hardest };

inline constexpr Words<AdaptiveMethod> adaptive_method_words = {
    {"quest", AdaptiveMethod::quest}, {"staircase", AdaptiveMethod::staircase}};
inline constexpr Words<LevelDirection> level_direction_words = {
    {"rising", LevelDirection::rising}, {"falling", LevelDirection::falling}};
inline constexpr Words<StaircaseStart> staircase_start_words = {
    {"easiest", StaircaseStart::easiest},
    {"middle", StaircaseStart::middle},
    {"hardest", StaircaseStart::hardest}};

/// Sizes of the steps of a staircase, in places of the grid of levels: towards easier levels (up)
/// and towards harder ones (down).
struct StaircaseSteps {
  int up = 1;
  int down = 1;
  friend bool operator==(const StaircaseSteps&, const StaircaseSteps&) = default;
};

/// `step: 2`, or `step: {up: 3, down: 1}`.
struct StaircaseStepsForm {
  static void read(const DocumentValue& given, StaircaseSteps& steps);
  static nlohmann::ordered_json write(const StaircaseSteps& steps, const WritingOptions& how);
  static void walk(auto& names) {
    names.add("up");
    names.add("down");
  }
};

/// When a track of QUEST+ ends.
struct TrackStop {
  /// As soon as the posterior standard deviation of the threshold is at most this, in units of the
  /// factor.
  double sd = 0.0;
  int at_most = 40;  ///< or after so many trials

  friend bool operator==(const TrackStop&, const TrackStop&) = default;
};

void fields_of(auto&& field, MaybeConst<TrackStop> auto& stop) {
  field("sd", stop.sd, concerns::required);
  field("at_most", stop.at_most, concerns::required);
}

/// Adaptive trials: the level of a factor that each trial shows depends on the participant's
/// answers so far. The films of all levels are made beforehand (adaptive_levels.h).
struct AdaptiveTrialSettings {
  AdaptiveMethod method = AdaptiveMethod::quest;
  std::string factor;  ///< its levels are numbers; empty: trials are not adaptive
  LevelDirection easier = LevelDirection::rising;
  int trials = 40;     ///< of each track; with reversals, at most; not with `until`
  int tracks = 1;      ///< interleaved, each with answers of its own
  double noise = 0.2;  ///< of yes–no and same–different trials: the share without the signal
  /// The probability of positive answers at the threshold; unset: that to which a staircase
  /// converges, otherwise 0.75.
  std::optional<double> proportion;
  std::optional<TrackStop> until;  ///< of QUEST+; unset: all trials are shown
  // Of staircases:
  int up = 1;           ///< negative answers in succession to an easier level
  int down = 2;         ///< positive answers in succession to a harder level
  StaircaseSteps step;  ///< in places of the grid
  int reversals = 0;    ///< with which a track ends; 0: all trials are shown
  StaircaseStart start = StaircaseStart::easiest;

  bool empty() const { return factor.empty(); }
  /// Whether tracks may end before the greatest number of trials.
  bool may_end_early() const { return until || reversals > 0; }
  friend bool operator==(const AdaptiveTrialSettings&, const AdaptiveTrialSettings&) = default;
};

void fields_of(auto&& field, MaybeConst<AdaptiveTrialSettings> auto& adaptive) {
  field("method", adaptive.method, concerns::nothing, adaptive_method_words);
  field("factor", adaptive.factor, concerns::nothing);
  field("easier", adaptive.easier, concerns::nothing, level_direction_words);
  field("trials", adaptive.trials, concerns::nothing);
  field("tracks", adaptive.tracks, concerns::nothing);
  field("noise", adaptive.noise, concerns::nothing);
  field("proportion", adaptive.proportion, concerns::nothing);
  field("until", adaptive.until, concerns::nothing);
  field("up", adaptive.up, concerns::nothing);
  field("down", adaptive.down, concerns::nothing);
  field.by("step", adaptive.step, concerns::nothing, StaircaseStepsForm());
  field("reversals", adaptive.reversals, concerns::nothing);
  field("start", adaptive.start, concerns::nothing, staircase_start_words);
}

}  // namespace mien::pipeline
