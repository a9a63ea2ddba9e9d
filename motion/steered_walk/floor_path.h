#pragma once

#include <span>
#include <vector>

#include "motion/math/geometry.h"

namespace mien::motion {

/// A way over the floor, in equal steps, its corners rounded. y is 0.
struct FloorPath {
  std::vector<Vec3> points;
  double step_m = 0.05;  ///< from point to point

  double length() const { return step_m * static_cast<double>(points.size() - 1); }
};

/// The polyline through points (x, z in metres; y is not looked at) as a path whose corners are
/// rounded over some 0.3 m. The ends stay. Throws mien::Error for numbers that are none and for
/// less than 0.1 m of way.
FloorPath floor_path(std::span<const Vec3> polyline);

/// The place after a way of so many metres; beyond the end straight on.
Vec3 point_at(const FloorPath& path, double way);

/// Where the path goes there, about +Y from +Z, radians.
double heading_at(const FloorPath& path, double way);

/// Largest curvature, 1/m, between two ways.
double largest_curvature(const FloorPath& path, double from, double to);

/// The way of the point nearest to a place, looked for from `last` to 0.6 m on, so that a path that
/// crosses itself is not cut short.
double nearest_way(const FloorPath& path, const Vec3& place, double last);

}  // namespace mien::motion
