#pragma once

#include <string>

#include "motion/measures/distance/distance.h"
#include "motion/skeleton/body.h"
#include "pipeline/base/drawing/canvas.h"
#include "pipeline/production/sheets/sheet.h"

namespace mien::pipeline {

/// The layout of a comparison sheet on its A3 landscape page, in points.
///
/// Figures and heat map share eleven columns, heat map and joint bars share twenty rows, so that
/// each cell aligns with its figure above and its joint at the side.
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

/// Width of the space for names to the left of figures and heat map, in points.
inline constexpr double name_width = 112.0;

/// Returns the column of normalized time t/10 in a block as wide as the figures.
Box time_column(const Box& block, int t);

/// Returns the row of a joint (1 … 20) in a block as high as the heat map; body parts are separated
/// by small gaps.
Box joint_row(const Box& block, int joint);

/// Returns the row below the joints, for means over joints.
Box mean_row(const Box& block);

/// Returns the end of the scale of distances in metres: the smallest multiple of the threshold, at
/// least twice the threshold, that covers every distance.
double amount_limit(const motion::Distance& distance);

// The parts of a comparison sheet; each is drawn within its box.

/// Title, study, and the mark of simulated ratings.
void draw_header(Canvas& canvas, const SheetContent& content, const Box& box);

/// D, the verdict, and the position of D on a scale with the threshold.
void draw_verdict(Canvas& canvas, const SheetContent& content, const Box& box);

/// The parameters with the values of both motions, requested ones with a slider; below, the blend
/// weights of both as bars. Of parameters that do not fit, only the number is given; of weights
/// that do not fit, the sum.
void draw_settings(Canvas& canvas, const SheetContent& content, const Box& box);
void draw_parameters(Canvas& canvas, const SheetContent& content, const Box& box);
void draw_weights(Canvas& canvas, const SheetContent& content, const Box& box);

/// A row of stick figures at the eleven times for each motion, and a row of target and created
/// motion together. All have one scale and an orthographic view from the right and slightly ahead,
/// with the horizontal position and heading of the pelvis removed at each time.
void draw_figures(Canvas& canvas, const SheetContent& content, const Box& box);

/// The distance of every joint at every time as a colour, and the mean over joints at each time as
/// a number.
void draw_heat_map(Canvas& canvas, const SheetContent& content, const Box& box);

/// Mean and largest distance of each joint, next to its row of the heat map.
void draw_joint_bars(Canvas& canvas, const SheetContent& content, const Box& box);

/// Position over time of the three joints with the largest mean distance; the plots of a joint
/// share one scale.
void draw_curves(Canvas& canvas, const SheetContent& content, const Box& box);

/// The provenance of the sheet, and the definitions of its numbers.
void draw_footer(Canvas& canvas, const SheetContent& content, const Box& box);

/// Returns a readable name: "Left shoulder" for LeftShoulder.
std::string spoken_name(motion::BodyJoint joint);

/// The heading of a part, followed by a remark.
void draw_heading(Canvas& canvas, Point baseline, const std::string& heading,
                  const std::string& remark = {});

/// The columns for the numbers of both motions at the right of the weights.
struct ValueColumns {
  double target;  ///< right edges, points
  double created;
};

ValueColumns value_columns(const Box& box);

}  // namespace mien::pipeline
