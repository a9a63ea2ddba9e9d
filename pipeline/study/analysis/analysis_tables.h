#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/ratings/scales/scales.h"
#include "pipeline/study/analysis/analysis.h"

namespace mien::pipeline {

// The results of an analysis as tidy CSV: one row an observation.

WrittenTable quantification_table(const Analysis& analysis, const ScaleSet& scales);
WrittenTable thresholds_table(const Analysis& analysis, const ScaleSet& scales,
                              const Thresholds& thresholds);
WrittenTable linkage_table(const Analysis& analysis);
WrittenTable clusters_table(const Analysis& analysis);
WrittenTable primary_table(const Analysis& analysis);
WrittenTable agreement_table(const Analysis& analysis);
WrittenTable warnings_table(const std::vector<StudyWarning>& warnings);

}  // namespace mien::pipeline
