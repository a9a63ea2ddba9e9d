#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/regression_limits.h"

namespace mien::pipeline {

/// What may go farther now than it might when a stimulus was approved: "position_mm 1 → 50", "left
/// hand 1 → 5 mm". Whoever loosens a guard together with what it guards is seen.
std::vector<std::string> wider_limits(const RegressionLimits& approved,
                                      const RegressionLimits& now);

}  // namespace mien::pipeline
