#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "motion/text/words.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/power.h"
#include "pipeline/study/questionnaire/simulated_sessions.h"

namespace mien::pipeline {

/// Settings of a simulation of the planned tests of a study.
///
/// Each simulated rating is the sum of the assumed mean of its cell (a combination of levels of the
/// analysed factors), a participant effect, a stimulus effect, an effect of the participant in the
/// cell and a residual, all normally distributed, for the stimuli that the design assigns to the
/// participant. In pairs, the stimulus with the higher rating is chosen, as by simulated
/// participants (simulated_sessions.h). Each simulated study is analysed as its report would be
/// (factor_effects.h, factor_contrasts.h, worth_contrasts.h).
struct PlannedPowerOptions {
  /// Of each scale of the questionnaire, in points; a single one without a name holds for all.
  std::vector<ScaleSpread> spreads;
  /// Assumed true ratings. The mean of a cell is the mean of its stimuli, a missing one being the
  /// middle of the scale. Nullopt: each test is simulated on its own, with an effect of
  /// `difference` and no effect in the others.
  std::optional<StatedTruth> truth;
  /// Assumed size of an effect, in points: of a contrast, its value; of a main effect, the
  /// difference between first and last level, the others lying in the middle (Cohen 1988, pattern
  /// of minimum variability); of an interaction, the difference of these differences.
  double difference = 0.5;
  std::vector<int> participants;      ///< numbers of participants, ascending
  std::vector<int> stimuli_per_cell;  ///< numbers of stimuli, ascending; empty: as in the manifest
  std::vector<double> groups;         ///< relative sizes of groups; empty: two equal groups
  int studies = 1000;                 ///< number of simulated studies of each size
  std::uint64_t seed = 0;
  /// Called with the share of the work that is done, 0 to 1. It may throw to stop.
  std::function<void(double)> progress;
};

enum class TestedBy {
  participants,              ///< stimuli are fixed: as in the report
  participants_and_stimuli,  ///< both are random effects (crossed_test.h)
};

inline constexpr Words<TestedBy> tested_by_words = {
    {"participants", TestedBy::participants},
    {"participants-and-stimuli", TestedBy::participants_and_stimuli}};

/// The power of one planned test in a study of one size.
struct PlannedTestPower {
  bool is_contrast = false;  ///< a planned contrast; otherwise an effect of the factors
  std::string name;
  std::string scale;  ///< id
  TestedBy by = TestedBy::participants;
  int participants = 0;
  int stimuli_per_cell = 0;  ///< 0: different numbers, as in the manifest
  double people = 0.0;       ///< mean number of participants whose answers are complete
  double assumed = 0.0;      ///< assumed value of a contrast; NaN of effects by stated true ratings
  int studies = 0;           ///< number of simulated studies in which the test was possible
  /// Share of studies in which the test is significant, adjusted as the analysis plan states.
  SimulatedShare power;
  double power_error = 0.0;  ///< its Monte-Carlo standard error
  /// Share of studies without any true effect in which the test, not adjusted, is significant.
  SimulatedShare false_positives;
};

/// Simulates studies of all sizes and tests each of them. Studies of different numbers of
/// participants share simulated participants. Deterministic in the seed. The rows are sorted by
/// test, then by size. Tests with both random effects are omitted if participants do not see all
/// stimuli, if there is one stimulus in each cell, for effects of groups, and for pairs.
///
/// Throws Error for studies without planned tests, for other kinds of trials, for variances that
/// lack a scale, and if more than most_simulated_answers would be simulated.
std::vector<PlannedTestPower> planned_power(const Manifest& manifest,
                                            const PlannedPowerOptions& options);

inline constexpr double most_simulated_answers = 2e10;

}  // namespace mien::pipeline
