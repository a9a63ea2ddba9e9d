#pragma once

#include <vector>

#include "pipeline/base/drawing/plot.h"
#include "pipeline/study/analysis/quantification.h"

namespace mien::pipeline {

/// How many scales each threshold keeps: a panel a condition, the fine line by the condition alone,
/// the broad one with the other threshold where it is, the threshold in use as a broken line.
/// `scales`: how many were rated.
Plot threshold_chart(const std::vector<KeptAt>& curve, const Thresholds& thresholds, int scales,
                     bool simulated);

}  // namespace mien::pipeline
