#pragma once

#include <span>
#include <vector>

#include "motion/math/geometry.h"

namespace mien::motion {

/// A path on the floor with rounded corners; y is 0. Its points are equally spaced along the
/// polyline from which it was made; arc lengths are measured along that polyline.
struct FloorPath {
  std::vector<Vec3> points;
  double step_m = 0.05;  ///< arc length between points

  double length() const { return step_m * static_cast<double>(points.size() - 1); }
};

/// The polyline through points (x, z in metres; y is ignored) as a path whose corners are rounded
/// over about 0.3 m. The end points are kept. Throws mien::Error for non-finite numbers and for a
/// path shorter than 0.1 m.
FloorPath floor_path(std::span<const Vec3> polyline);

/// The point at an arc length, metres; beyond the end the path continues straight.
Vec3 point_at(const FloorPath& path, double way);

/// Heading of the path at an arc length, about +Y from +Z, radians.
double heading_at(const FloorPath& path, double way);

/// Largest curvature, 1/m, between two arc lengths.
double largest_curvature(const FloorPath& path, double from, double to);

/// Arc length, metres, of the path's point nearest to `place`. Only arc lengths from `last` to 0.6
/// m farther are searched, so that no loop of a self-crossing path is skipped.
double nearest_way(const FloorPath& path, const Vec3& place, double last);

}  // namespace mien::motion
