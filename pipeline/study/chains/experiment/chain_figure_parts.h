#pragma once

#include <string>

#include "pipeline/base/drawing/canvas.h"
#include "pipeline/study/chains/experiment/chain_results.h"

namespace mien::pipeline {

// Parts of the figures of chains. Lengths are in points.

inline constexpr double figure_margin = 20.0;
inline constexpr double figure_header = 44.0;
inline constexpr double names_width = 110.0;

/// The title, a line of explanation and, for simulated answers, a mark.
void draw_figure_header(Canvas& canvas, const ChainResults& results, const std::string& title,
                        const std::string& words, double width);

/// The share of a value in the range of its dimension, clamped to 0…1.
double share_of(const DimensionRange& range, double value);

}  // namespace mien::pipeline
