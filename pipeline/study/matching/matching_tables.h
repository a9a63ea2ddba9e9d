#pragma once

#include <filesystem>
#include <string>

#include "pipeline/study/matching/matching_evaluation.h"

namespace mien::pipeline {

// An evaluation as tidy CSV. Every table has the column `sessions`: "given" or "simulated".

/// A row a measure (first_guess_d in metres, time_s), interface and target ("all": over the means
/// of participants): measure, interface, target, sessions, n, mean, sd (n − 1).
std::string means_csv(const MatchingEvaluation& evaluation, bool simulated);

/// A row an interface and target (or "all"): interface, target, sessions, guesses, near_guesses (D
/// below the threshold), near_share, trials, failures, failure_share.
std::string shares_csv(const MatchingEvaluation& evaluation, bool simulated);

/// A row a pair of interfaces and target (or "all"): first, second, target, sessions, participants,
/// saved_s (seconds that the second saves: mean of the first less the second), low_90, high_90
/// (ends of the 90 % interval; empty where all differences are the same).
std::string time_saved_csv(const MatchingEvaluation& evaluation, bool simulated);

/// A row a measure, pair of interfaces and target (or "all"), first less second: measure, first,
/// second, target, sessions,
/// participants, mean_difference, w_plus, w_minus, p_paper (normal approximation without
/// continuity correction), p_paper_holm, p_exact, p_exact_holm, rank_biserial, d_z, t, p_t.
std::string comparisons_csv(const MatchingEvaluation& evaluation, bool simulated);

/// Writes means.csv, shares.csv, time_saved.csv, comparisons.csv and the figures first_guess_d,
/// first_guess_success, time, time_saved and failures as .pdf, .svg and .png, which are figures 7
/// to 11 of the adjective paper.
void write_evaluation(const MatchingEvaluation& evaluation, const MatchingResults& results,
                      const std::filesystem::path& folder);

}  // namespace mien::pipeline
