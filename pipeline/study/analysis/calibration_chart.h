#pragma once

#include "pipeline/base/drawing/plot.h"
#include "pipeline/study/analysis/calibration.h"

namespace mien::pipeline {

/// A panel a parameter: what people saw (with the standard deviation) over what was asked for, what
/// the blend has, the line of the correction, and the diagonal on which asked is seen.
Plot calibration_chart(const Calibration& calibration);

}  // namespace mien::pipeline
