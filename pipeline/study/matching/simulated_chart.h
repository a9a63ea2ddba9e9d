#pragma once

#include <vector>

#include "pipeline/base/drawing/plot.h"
#include "pipeline/study/matching/simulated_evaluation.h"

namespace mien::pipeline {

/// Bars of what the interfaces came to, marked as simulated: D of the nearest slider settings and
/// of first guesses with ±1 SD and the threshold, success of first guesses, failures (after figures
/// 7, 8 and 11 of the adjective paper).
Plot simulated_chart(const std::vector<InterfaceSummary>& summaries, double threshold_m);

}  // namespace mien::pipeline
