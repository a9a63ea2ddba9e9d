#pragma once

#include <vector>

#include "pipeline/study/results/figures/result_figures.h"

namespace mien::pipeline {

/// Modified, acted and neutral motions against each other, within persons: over all settings, then
/// video by video.
void add_difference_figures(const Results& results, std::vector<ResultFigure>& figures);

}  // namespace mien::pipeline
