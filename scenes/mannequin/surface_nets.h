#pragma once

#include <array>
#include <functional>
#include <vector>

#include "motion/math/geometry.h"

namespace mien::scenes {

/// The planes of a rectilinear grid: ascending coordinates, at least two for each axis, not
/// necessarily evenly spaced.
struct Grid {
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> z;
};

/// A closed surface of triangles.
struct Surface {
  std::vector<motion::Vec3> positions;
  std::vector<motion::Vec3> normals;          ///< unit, outward
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from outside
};

/// A signed distance field, negative inside; its values may be up to 1.3 times the true distance.
using SignedDistance = std::function<double(const motion::Vec3&)>;

/// The surface where `field` is zero, by the dual of marching cubes (Nielson 2004): one vertex for
/// each sheet in a cell, at the mean of the points where the sheet crosses the cell's edges
/// (surface nets, Gibson 1998), then moved onto the surface along the field's gradient. On
/// ambiguous faces the inside regions are kept separate.
///
/// Watertight if the surface does not touch the boundary of the grid. Blocks of the grid that
/// contain no surface, judging by the field at their centre, are skipped.
Surface surface_nets(const SignedDistance& field, const Grid& grid);

/// Unit gradient of the field by finite differences over `step` metres; +Y where it vanishes.
motion::Vec3 field_normal(const SignedDistance& field, const motion::Vec3& point, double step);

}  // namespace mien::scenes
