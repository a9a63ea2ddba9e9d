#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// The stimuli of one level of the factor of adaptive trials.
struct AdaptiveLevel {
  double value = 0.0;
  std::string text;                  ///< as the manifest states it
  std::vector<std::string> stimuli;  ///< ids
};

/// What adaptive trials can show.
struct AdaptiveLevels {
  std::vector<AdaptiveLevel> grid;      ///< with the signal, from the hardest level to the easiest
  std::vector<std::string> references;  ///< ids of the stimuli without the signal
};

/// The least and the greatest number of levels of a grid.
inline constexpr std::size_t least_adaptive_levels = 3;
inline constexpr std::size_t most_adaptive_levels = 40;

/// The level of a stimulus as a number; NaN if it has none or it is not a number.
double adaptive_level_of(const Manifest& manifest, const std::string& stimulus);

/// The levels of a questionnaire with adaptive trials. If it names no stimuli with the signal, all
/// have it except those of the hardest level. Stimuli whose level is not a number are left out (the
/// checks report them).
AdaptiveLevels adaptive_levels(const Manifest& manifest);

/// The ids of rated stimuli whose level is not the hardest.
std::vector<std::string> stimuli_above_hardest_level(const Manifest& manifest);

/// The stimuli without the signal with which a stimulus may be shown: those that agree with it in
/// the levels of the most factors.
std::vector<std::string> references_of(const Manifest& manifest, const AdaptiveLevels& levels,
                                       const std::string& stimulus);

/// The probability of positive answers to which the staircase of a questionnaire converges
/// (staircase_target).
double staircase_proportion(const AdaptiveTrialSettings& adaptive);

/// The probability of positive answers at the threshold.
double threshold_proportion(const AdaptiveTrialSettings& adaptive);

/// The greatest number of trials of a track.
int most_track_trials(const AdaptiveTrialSettings& adaptive);

/// The number of trials without the signal in a session, at least 1; 0 in two-interval trials.
int adaptive_noise_trials(const Questionnaire& asked);

/// The greatest number of trials of a session, those without the signal among them.
int adaptive_session_trials(const Questionnaire& asked);

}  // namespace mien::pipeline
