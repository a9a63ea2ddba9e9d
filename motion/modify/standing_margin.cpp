#include <algorithm>
#include <limits>

#include "motion/biomechanics/body_mass.h"
#include "motion/modify/posture.h"

namespace mien::motion {

namespace {

using Point = Eigen::Vector2d;  // x and z on the floor's plane

double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Corners of both soles, as wide as feet are.
std::vector<Point> sole_corners(const Skeleton& body, const JointTransforms& world) {
  const double scale = standing_height(body) / 1.75;
  std::vector<Point> corners;
  for (const auto& [ankle, toe] : {std::pair{LeftAnkle, LeftToe}, {RightAnkle, RightToe}}) {
    const Quat& foot = world.rotations[static_cast<size_t>(ankle)];
    const Vec3 heel =
        world.positions[static_cast<size_t>(ankle)] + scale * (foot * Vec3(0, 0, -0.045));
    const Vec3 tip = world.positions[static_cast<size_t>(toe)] + scale * (foot * Vec3(0, 0, 0.06));
    for (const Vec3& middle : {heel, tip}) {
      for (const double side : {-0.04, 0.04}) {
        const Vec3 corner = middle + scale * (foot * Vec3(side, 0, 0));
        corners.emplace_back(corner.x(), corner.z());
      }
    }
  }
  return corners;
}

/// Corners of the convex hull, anticlockwise (Andrew's monotone chain).
std::vector<Point> convex_hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  std::vector<Point> hull;
  for (int side = 0; side < 2; ++side) {
    const size_t start = hull.size();
    for (const Point& point : points) {
      while (hull.size() >= start + 2 &&
             cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(point);
    }
    hull.pop_back();  // begins the other side
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

double distance_to_edge(const Point& point, const Point& from, const Point& to) {
  const Point along = to - from;
  const double t = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - from - t * along).norm();
}

}  // namespace

double standing_margin(const Skeleton& body, const Pose& pose) {
  const JointTransforms world = world_transforms(body, pose);
  const Vec3 mass = centre_of_mass(body, world);
  const Point centre(mass.x(), mass.z());
  const std::vector<Point> hull = convex_hull(sole_corners(body, world));
  bool inside = true;
  double nearest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < hull.size(); ++i) {
    const Point& from = hull[i];
    const Point& to = hull[(i + 1) % hull.size()];
    inside = inside && cross(to - from, centre - from) >= 0.0;
    nearest = std::min(nearest, distance_to_edge(centre, from, to));
  }
  return inside ? nearest : -nearest;
}

}  // namespace mien::motion
