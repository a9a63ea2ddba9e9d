#pragma once

#include <filesystem>

#include "pipeline/base/drawing/bar_chart.h"
#include "pipeline/study/matching/matching_evaluation.h"

namespace mien::pipeline {

/// Writes means.csv, shares.csv, time_saved.csv, comparisons.csv and the figures first_guess_d,
/// first_guess_success, time, time_saved and failures as .pdf, .svg and .png, which are figures 7
/// to 11 of the adjective paper. Targets are "all" over the means of participants.
void write_evaluation(const MatchingEvaluation& evaluation, const MatchingResults& results,
                      const std::filesystem::path& folder);

// Figures 7 to 11 of the adjective paper: bars of the interfaces, target by target, then over all.
// With more than twelve targets, only over all.

/// D of the first guess, mean over participants ± 1 SD, with the threshold.
BarChart first_guess_chart(const MatchingEvaluation& evaluation, bool simulated);
/// Share of first guesses below the threshold.
BarChart first_guess_success_chart(const MatchingEvaluation& evaluation, bool simulated);
/// Seconds until the match, mean over participants ± 1 SD.
BarChart time_chart(const MatchingEvaluation& evaluation, bool simulated);
/// Seconds that the second interface of each pair saves (first less second), with 90 % intervals:
/// above 0 where the second is faster.
BarChart time_saved_chart(const MatchingEvaluation& evaluation, bool simulated);
/// Share of trials without a match.
BarChart failures_chart(const MatchingEvaluation& evaluation, bool simulated);

}  // namespace mien::pipeline
