#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/ratings/scales/scales.h"
#include "pipeline/study/analysis/analysis.h"

namespace mien::pipeline {

// The results of an analysis as tidy CSV: one row an observation. Every table has the column
// `ratings`: "given" by people or "simulated".

/// A row a scale: scale, low, high, ratings, answers, max_abs_mean (largest distance of an
/// example's mean from the middle, in the scale's units), at_example, mean_sd (same units; empty
/// for given means), least_max_abs_mean and most_mean_sd (the thresholds, restated for the scale's
/// range), kept (1 or 0), removed_by (neutral, disagreement, neutral+disagreement or empty).
std::string quantification_csv(const Analysis& analysis, const ScaleSet& scales);

/// A row a threshold: condition (max_abs_mean or mean_sd), ratings, threshold (for answers from
/// −2 to 2), kept_by_condition, kept_by_both.
std::string thresholds_csv(const Analysis& analysis, const ScaleSet& scales,
                           const Thresholds& thresholds);

/// A row a merge: step, first, second (a scale, or "#3" for what step 3 made), size, members
/// (joined by blanks), ratings, delta_e (ΔE), height (√(2ΔE)).
std::string linkage_csv(const Analysis& analysis);

/// A row a clustered scale: cluster (1 …, along the dendrogram), name, scale, ratings, rank (1 is
/// nearest to the centroid), to_centroid, basis (kept, or all when no scale was kept).
std::string clusters_csv(const Analysis& analysis);

/// A row a cluster and example, the matrix A′: primary, example, ratings, impression (0 … 1).
std::string primary_csv(const Analysis& analysis);

/// A row a scale: scale, ratings, raters, complete_raters (who rated every example), alpha and
/// icc_2_k (of those), answers_per_example, icc_1_k (of all answers). Empty where undefined.
std::string agreement_csv(const Analysis& analysis);

/// A row a warning: kind, file, line, column, message.
std::string warnings_csv(const std::vector<StudyWarning>& warnings);

}  // namespace mien::pipeline
