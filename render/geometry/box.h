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

/// The box, larger by more than any rounding in the intersection with what it contains.
Box padded(const Box& box);

}  // namespace mien::render
