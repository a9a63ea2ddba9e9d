#pragma once

#include "render/geometry/prepared_cone.h"
#include "render/geometry/triangle.h"

namespace mien::render {

/// A box with sides along the axes, metres.
struct Box {
  Eigen::Array3f lower;
  Eigen::Array3f upper;
};

Box box_of(const PreparedCone& cone);
Box box_of(const Triangle& triangle);

/// The box around two boxes.
Box hull(const Box& a, const Box& b);

/// The box, enlarged on all sides by more than the rounding errors of intersecting a ray with the
/// shapes in it.
Box padded(const Box& box);

}  // namespace mien::render
