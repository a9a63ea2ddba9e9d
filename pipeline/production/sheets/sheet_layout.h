#pragma once

#include "motion/measures/distance/distance.h"
#include "pipeline/base/drawing/canvas.h"

namespace mien::pipeline {

/// Where the parts of a comparison sheet stand on its A3 landscape page, points.
///
/// Figures and heat map share their eleven columns, heat map and joint bars their twenty rows, so
/// that a cell is read upwards to the figure and sideways to the joint.
struct SheetLayout {
  double width = 1190.55;
  double height = 841.89;
  Box header;
  Box verdict;
  Box settings;  ///< parameters and weights
  Box figures;
  Box heat_map;
  Box joint_bars;
  Box curves;
  Box footer;
};

SheetLayout sheet_layout();

/// Space for names at the left of figures and heat map.
inline constexpr double name_width = 112.0;

/// The column of time t/10 in a block as wide as the figures.
Box time_column(const Box& block, int t);

/// The row of a joint (1 … 20) in a block as high as the heat map; parts of the body stand a little
/// apart.
Box joint_row(const Box& block, int joint);

/// The row below the joints, for means over joints.
Box mean_row(const Box& block);

/// End of the scale of distances, metres: the least multiple of the threshold, but at least twice
/// the threshold, that holds every distance.
double amount_limit(const motion::Distance& distance);

}  // namespace mien::pipeline
