#pragma once

#include "pipeline/analysis/calibration.h"
#include "pipeline/drawing/plot.h"

namespace mien::pipeline {

/// A panel a parameter: what people saw (with the standard deviation) over what was asked for, what
/// the blend has, the line of the correction, and the diagonal on which asked is seen.
Plot calibration_chart(const Calibration& calibration);

}  // namespace mien::pipeline
