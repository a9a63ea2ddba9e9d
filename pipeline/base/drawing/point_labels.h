#pragma once

#include <optional>
#include <vector>

#include "pipeline/base/drawing/canvas.h"

namespace mien::pipeline {

/// A point to label, with the width and height of its label, points.
struct LabelledPoint {
  Point at;
  double width = 0.0;
  double height = 0.0;
};

/// Places labels beside their points, in order: each at the first of the positions around its
/// point, nearer ones first, at which it is within `area` and overlaps neither another label nor a
/// mark of radius `radius` at any of the points or `others`. Labels that fit nowhere within `reach`
/// of their points have no box. All lengths in points.
std::vector<std::optional<Box>> place_labels(const std::vector<LabelledPoint>& points,
                                             const std::vector<Point>& others, double radius,
                                             const Box& area, double reach = 40.0);

}  // namespace mien::pipeline
