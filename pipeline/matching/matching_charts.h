#pragma once

#include "pipeline/drawing/bar_chart.h"
#include "pipeline/matching/matching_evaluation.h"

namespace mien::pipeline {

// Figures 7 to 11 of the adjective paper.

/// D of the first guess, mean over participants ± 1 SD, with the threshold.
BarChart first_guess_chart(const MatchingEvaluation& evaluation, bool simulated);
/// Share of first guesses below the threshold.
BarChart first_guess_success_chart(const MatchingEvaluation& evaluation, bool simulated);
/// Seconds until the match, mean over participants ± 1 SD.
BarChart time_chart(const MatchingEvaluation& evaluation, bool simulated);
/// Seconds saved by the second interface of each pair, with 90 % intervals.
BarChart time_saved_chart(const MatchingEvaluation& evaluation, bool simulated);
/// Share of trials without a match.
BarChart failures_chart(const MatchingEvaluation& evaluation, bool simulated);

}  // namespace mien::pipeline
