#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/ratings/scales/scales.h"
#include "pipeline/study/analysis/analysis.h"
#include "pipeline/study/analysis/dendrogram.h"

namespace mien::pipeline {

/// The dendrogram of an analysis, with the cut into clusters.
Dendrogram dendrogram_of(const Analysis& analysis, const ScaleSet& scales);

/// Writes the results of an analysis, replacing existing files: quantification.csv, thresholds.csv,
/// impressions.csv, linkage.csv, clusters.csv, primary.csv, agreement.csv, warnings.csv,
/// clusters.scales.yaml, dendrogram and thresholds as .pdf, .svg and .png; also published.csv if
/// all scales with answers are adjective pairs of the paper. Throws WriteFailure if a file cannot
/// be written.
void write_analysis(const Analysis& analysis, const ScaleSet& scales, const Thresholds& thresholds,
                    const std::filesystem::path& folder);

// The results of an analysis as tidy CSV: one row per observation.

WrittenTable quantification_table(const Analysis& analysis, const ScaleSet& scales);
WrittenTable thresholds_table(const Analysis& analysis, const ScaleSet& scales,
                              const Thresholds& thresholds);
WrittenTable linkage_table(const Analysis& analysis);
WrittenTable clusters_table(const Analysis& analysis);
WrittenTable primary_table(const Analysis& analysis);
WrittenTable agreement_table(const Analysis& analysis);
WrittenTable warnings_table(const std::vector<StudyWarning>& warnings);

}  // namespace mien::pipeline
