#pragma once

#include <filesystem>

#include "pipeline/base/drawing/bar_chart.h"
#include "pipeline/study/matching/matching_evaluation.h"

namespace mien::pipeline {

/// Writes the tables means.csv, shares.csv, time_saved.csv and comparisons.csv, in which rows over
/// all targets have the target "all". Writes the figures first_guess_d, first_guess_success, time,
/// time_saved and failures, each as .pdf, .svg and .png.
void write_evaluation(const MatchingEvaluation& evaluation, const MatchingResults& results,
                      const std::filesystem::path& folder);

// Figures 7 to 11 of the adjective paper: one bar per interface (or pair of interfaces), grouped by
// target, with a final group over all targets. With one target, or more than twelve, only that
// group is drawn.

/// D of the first guess in metres: mean ± 1 SD, with the threshold.
BarChart first_guess_chart(const MatchingEvaluation& evaluation, bool simulated);
/// Share of first guesses below the threshold.
BarChart first_guess_success_chart(const MatchingEvaluation& evaluation, bool simulated);
/// Seconds until the match: mean ± 1 SD. Trials without a match count with the time limit.
BarChart time_chart(const MatchingEvaluation& evaluation, bool simulated);
/// Seconds that the second interface of each pair saves (first − second), with 90 % intervals;
/// positive if the second is faster.
BarChart time_saved_chart(const MatchingEvaluation& evaluation, bool simulated);
/// Share of trials without a match.
BarChart failures_chart(const MatchingEvaluation& evaluation, bool simulated);

}  // namespace mien::pipeline
