#pragma once

#include <vector>

#include "pipeline/drawing.h"
#include "pipeline/interface_evaluation.h"

namespace mien::pipeline {

inline constexpr double interface_figure_width = 640.0;   ///< points
inline constexpr double interface_figure_height = 250.0;  ///< points

/// Bars of what the interfaces came to, marked as simulated: D of the nearest slider settings and
/// of first guesses with ±1 SD and the threshold, success of first guesses, failures (after figures
/// 7, 8 and 11 of the adjective paper).
void draw_interfaces(Canvas& canvas, const std::vector<InterfaceSummary>& summaries,
                     double threshold_m);

}  // namespace mien::pipeline
