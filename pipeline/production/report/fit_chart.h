#pragma once

#include "motion/fitting/fit_quality.h"
#include "pipeline/base/drawing/plot.h"

namespace mien::pipeline {

/// Draws how well a body fits a recording over time: above, the distance between body and points
/// (root mean square of each frame, the largest where several frames share a column of the chart);
/// below, a row for each point with gaps, light where it was filled, dark where it is missing.
Plot fit_chart(const motion::FitQuality& fit);

}  // namespace mien::pipeline
