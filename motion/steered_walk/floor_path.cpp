#include "motion/steered_walk/floor_path.h"

#include <algorithm>
#include <cmath>

#include "motion/error.h"

namespace mien::motion {

namespace {

/// Points a step apart along a polyline; the step is made to fit.
FloorPath in_steps(const std::vector<Vec3>& polyline, double length) {
  FloorPath path;
  const double steps = std::max(2.0, std::round(length / path.step_m));
  path.step_m = length / steps;
  double before = 0.0;
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    const double piece = (polyline[i] - polyline[i - 1]).norm();
    while (static_cast<double>(path.points.size()) * path.step_m < before + piece) {
      const double way = static_cast<double>(path.points.size()) * path.step_m - before;
      path.points.push_back(polyline[i - 1] + way / piece * (polyline[i] - polyline[i - 1]));
    }
    before += piece;
  }
  path.points.resize(static_cast<std::size_t>(steps));
  path.points.push_back(polyline.back());
  return path;
}

void round_corners(std::vector<Vec3>& points) {
  constexpr int passes = 24;  // of binomial weights: a standard deviation of 3.5 steps
  for (int pass = 0; pass < passes; ++pass) {
    Vec3 before = points.front();
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const Vec3 here = points[i];
      points[i] = 0.25 * before + 0.5 * here + 0.25 * points[i + 1];
      before = here;
    }
  }
}

}  // namespace

FloorPath floor_path(std::span<const Vec3> polyline) {
  std::vector<Vec3> points;
  double length = 0.0;
  for (const Vec3& point : polyline) {
    if (!point.allFinite()) throw Error("a path with an invalid number", "give metres");
    const double piece = points.empty() ? 1.0 : (horizontal(point) - points.back()).norm();
    if (piece < 1e-6) continue;
    if (!points.empty()) length += piece;
    points.push_back(horizontal(point));
  }
  if (length < 0.1) {
    throw Error("a path shorter than 0.1 m", "give at least two distinct points");
  }
  FloorPath path = in_steps(points, length);
  round_corners(path.points);
  return path;
}

Vec3 point_at(const FloorPath& path, double way) {
  const std::size_t last = path.points.size() - 1;
  const double place = std::max(0.0, way / path.step_m);
  const std::size_t i = std::min(static_cast<std::size_t>(place), last - 1);
  const double t = place - static_cast<double>(i);
  return path.points[i] + t * (path.points[i + 1] - path.points[i]);
}

double heading_at(const FloorPath& path, double way) {
  const double ahead = std::min(way + path.step_m, path.length());
  const Vec3 along =
      point_at(path, ahead) - point_at(path, std::max(0.0, ahead - 2.0 * path.step_m));
  return std::atan2(along.x(), along.z());
}

double largest_curvature(const FloorPath& path, double from, double to) {
  double largest = 0.0;
  const double end = path.length();
  for (double way = std::max(0.0, from); way + 2.0 * path.step_m < std::min(to, end);
       way += path.step_m) {
    const double turn =
        std::remainder(heading_at(path, way + 2.0 * path.step_m) - heading_at(path, way), 2.0 * pi);
    largest = std::max(largest, std::abs(turn) / (2.0 * path.step_m));
  }
  return largest;
}

double nearest_way(const FloorPath& path, const Vec3& place, double last) {
  double best = last;
  double least = (point_at(path, last) - horizontal(place)).norm();
  for (double way = last; way <= std::min(last + 0.6, path.length()); way += 0.02) {
    const double away = (point_at(path, way) - horizontal(place)).norm();
    if (away < least) {
      least = away;
      best = way;
    }
  }
  return best;
}

}  // namespace mien::motion
