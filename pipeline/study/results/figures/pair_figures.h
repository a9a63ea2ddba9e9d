#pragma once

#include <vector>

#include "pipeline/study/results/figures/result_figures.h"

namespace mien::pipeline {

/// Of each question asked about pairs: how often the first of either pair was chosen, with Wilson's
/// interval, against one half; a few pairs a figure.
void add_pair_figures(const Results& results, std::vector<ResultFigure>& figures);

}  // namespace mien::pipeline
