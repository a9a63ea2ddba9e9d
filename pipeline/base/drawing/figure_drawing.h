#pragma once

#include <vector>

#include "motion/skeleton/pose.h"
#include "pipeline/base/drawing/canvas.h"
#include "pipeline/base/drawing/palette.h"

namespace mien::pipeline {

// Stick figures on a page, for sheets.

/// A point of a figure in view space, metres. The view is orthographic and level, from the figure's
/// right and slightly in front, so that a figure walking forward (+Z) moves to the right.
struct ViewPosition {
  double right;
  double up;
  double depth;  ///< distance away from the viewer
};

/// A chain of bones drawn in one stroke, or the head.
struct Limb {
  std::vector<ViewPosition> joints;
  double width;  ///< metres
  bool left = false;
  bool head = false;

  double depth() const {
    double sum = 0.0;
    for (const ViewPosition& p : joints) sum += p.depth;
    // A head is a ball whose front hides the neck.
    return sum / static_cast<double>(joints.size()) - (head ? 0.1 : 0.0);
  }
};

/// Limbs, farthest first.
using Figure = std::vector<Limb>;

Figure figure_of(const motion::Skeleton& body, const motion::Pose& pose);

struct FigureStyle {
  MotionColours colours;
  double thickness = 1.0;  ///< factor of the limbs' width
  bool halo = true;        ///< a paper-coloured outline where one limb passes in front of another
};

/// Bounding rectangle of the joints of figures in view space, metres. It always includes the
/// vertical line from the floor to a height of 1 m at `right` 0.
struct FigureExtent {
  double left = 0.0;
  double right = 0.0;
  double bottom = 0.0;
  double top = 1.0;

  void include(const Figure& figure);
};

/// Maps view space in metres to positions on the page.
struct FigureScale {
  double points_per_metre;
  Point origin;  ///< where a point with `right` 0 and `up` 0, on the floor, is drawn

  Point at(const ViewPosition& p) const {
    return {origin.x + points_per_metre * p.right, origin.y - points_per_metre * p.up};
  }
};

void draw_figure(Canvas& canvas, const Figure& figure, const FigureStyle& style,
                 const FigureScale& scale);

}  // namespace mien::pipeline
