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

/// Writes for each of eight rays whether it may hit a shape of which this is the
/// padded box, at a distance up to `reach`: −1 if so, otherwise 0.
void find_rays_through(const Box& box, const RayLanes& rays, const float* reach, int* may_hit);

}  // namespace mien::render
