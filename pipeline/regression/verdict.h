#pragma once

#include "pipeline/manifest/regression_limits.h"
#include "pipeline/regression/comparison.h"

namespace mien::pipeline {

/// Says whether a stimulus counts as another, and for each limit that is passed a sentence. What a
/// picture changes by because of a motion that is within its limits is no reason; nor is noise,
/// unless the scene was asked for otherwise: its pictures have the noise of the old one.
void judge(StimulusComparison& comparison, const RegressionLimits& limits);

}  // namespace mien::pipeline
