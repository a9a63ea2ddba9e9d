#pragma once

#include <filesystem>

#include "pipeline/study/analysis/analysis.h"
#include "pipeline/study/analysis/dendrogram.h"

namespace mien::pipeline {

/// The tree of an analysis with its cut.
Dendrogram dendrogram_of(const Analysis& analysis, const ScaleSet& scales);

/// Writes every table, the clusters as a scales file and the dendrogram, replacing what is there:
/// quantification.csv, thresholds.csv, impressions.csv, linkage.csv, clusters.csv, primary.csv,
/// agreement.csv, warnings.csv, clusters.scales.yaml, dendrogram and thresholds as .pdf, .svg and
/// .png; and published.csv when the scales are the adjective pairs. Throws std::system_error when a
/// file cannot be written.
void write_analysis(const Analysis& analysis, const ScaleSet& scales, const Thresholds& thresholds,
                    const std::filesystem::path& folder);

}  // namespace mien::pipeline
