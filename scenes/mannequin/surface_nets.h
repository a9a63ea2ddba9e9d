#pragma once

#include <array>
#include <functional>
#include <vector>

#include "motion/math/geometry.h"

namespace mien::scenes {

/// The planes of a grid: ascending coordinates, at least two an axis, not evenly spaced perhaps.
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

/// Signed distance, or nearly: negative inside, and never further from it than the distance's true
/// size by more than half.
using SignedDistance = std::function<double(const motion::Vec3&)>;

/// The surface where `field` is zero, by the dual of marching cubes (Nielson 2004): one vertex for
/// each sheet in a cell, among the points where the sheet crosses the cell's edges (surface nets,
/// Gibson 1998), then moved onto the surface along the field's gradient. Across the diagonal of a
/// face that has both signs twice, insides are taken apart.
///
/// Watertight where the surface keeps clear of the grid's rim. Distances at a grid's block are
/// taken to say how far the surface is, so that most of the grid is never looked at.
Surface surface_nets(const SignedDistance& field, const Grid& grid);

/// Direction in which the field grows, unit, by differences over `step` metres.
motion::Vec3 field_normal(const SignedDistance& field, const motion::Vec3& point, double step);

}  // namespace mien::scenes
