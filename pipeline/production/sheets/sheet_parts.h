#pragma once

#include <string>

#include "motion/measures/distance/distance.h"
#include "motion/skeleton/body.h"
#include "pipeline/base/drawing/canvas.h"
#include "pipeline/production/sheets/sheet.h"

namespace mien::pipeline {

/// The layout of a comparison sheet on its A3 landscape page, in points.
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

// The parts of a comparison sheet; each keeps within its box.

/// Title, study, and the mark of simulated ratings.
void draw_header(Canvas& canvas, const SheetContent& content, const Box& box);

/// D, the verdict, and where D lies on a scale with the threshold.
void draw_verdict(Canvas& canvas, const SheetContent& content, const Box& box);

/// A slider a parameter with the marks of both motions, then the blend weights of both as bars.
void draw_settings(Canvas& canvas, const SheetContent& content, const Box& box);
void draw_parameters(Canvas& canvas, const SheetContent& content, const Box& box);
void draw_weights(Canvas& canvas, const SheetContent& content, const Box& box);

/// A row of stick figures a motion at the eleven times, and one of target and created together. All
/// at one scale, orthographic from the right and a little ahead, pelvis and heading as the distance
/// aligns them.
void draw_figures(Canvas& canvas, const SheetContent& content, const Box& box);

/// Joint × time distances as colours, and their mean over joints as numbers.
void draw_heat_map(Canvas& canvas, const SheetContent& content, const Box& box);

/// Mean and largest distance of each joint, beside its row of the heat map.
void draw_joint_bars(Canvas& canvas, const SheetContent& content, const Box& box);

/// Position over time of the three joints with the largest mean distance, the plots of
/// a joint at one scale.
void draw_curves(Canvas& canvas, const SheetContent& content, const Box& box);

/// What made the sheet, and how its numbers are defined.
void draw_footer(Canvas& canvas, const SheetContent& content, const Box& box);

/// "LeftShoulder" as "Left shoulder".
std::string spoken_name(motion::BodyJoint joint);

/// The heading of a part, and a remark behind it.
void draw_heading(Canvas& canvas, Point baseline, const std::string& heading,
                  const std::string& remark = {});

/// Columns at the right end of parameters and weights where the two motions' numbers stand.
struct ValueColumns {
  double target;  ///< right edges, points
  double created;
};

ValueColumns value_columns(const Box& box);

}  // namespace mien::pipeline
