#include "motion/biomechanics/support.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/biomechanics/weight_bearing.h"
#include "motion/skeleton/sole.h"

namespace mien::motion {

namespace {

constexpr double sole_width = 0.09;  // m at 1.75 m
constexpr double touching_metres = 0.03;

double lowest_of(const SolePoints& sole) {
  return std::min({sole.heel.y(), sole.ball.y(), sole.tip.y()});
}

std::vector<Vec3> bearing_corners(const SolePoints& sole, double lowest, double scale) {
  const Vec3 along = horizontal(sole.ball - sole.heel);
  const Vec3 side = 0.5 * sole_width * scale * Vec3(along.z(), 0.0, -along.x()).normalized();
  std::vector<Vec3> corners;
  for (const Vec3& point : {sole.heel, sole.ball, sole.tip}) {
    if (point.y() > lowest + touching_metres * scale) continue;
    corners.push_back(horizontal(point) + side);
    corners.push_back(horizontal(point) - side);
  }
  return corners;
}

double turn(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b.x() - a.x()) * (c.z() - a.z()) - (b.z() - a.z()) * (c.x() - a.x());
}

/// Convex hull in the plane, counter-clockwise as seen with x right and z up (Andrew 1979).
std::vector<Vec3> hull(std::vector<Vec3> points) {
  const auto before = [](const Vec3& a, const Vec3& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.z() < b.z();
  };
  std::sort(points.begin(), points.end(), before);
  std::vector<Vec3> result;
  const auto add_chain = [&](auto first, auto last, size_t kept) {
    for (auto point = first; point != last; ++point) {
      while (result.size() > kept + 1 &&
             turn(result[result.size() - 2], result.back(), *point) <= 0.0) {
        result.pop_back();
      }
      result.push_back(*point);
    }
    result.pop_back();
  };
  if (points.size() < 3) return points;
  add_chain(points.begin(), points.end(), 0);
  add_chain(points.rbegin(), points.rend(), result.size());
  return result;
}

Vec3 nearest_on_edge(const Vec3& point, const Vec3& a, const Vec3& b) {
  const Vec3 edge = b - a;
  const double squared = edge.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((point - a).dot(edge) / squared, 0.0, 1.0) : 0.0;
  return a + share * edge;
}

struct Nearest {
  Vec3 point;
  double distance = std::numeric_limits<double>::infinity();
  bool is_inside = true;
};

Nearest nearest(const Vec3& point, const std::vector<Vec3>& corners) {
  const std::vector<Vec3> edges = hull(corners);
  Nearest result;
  result.is_inside = edges.size() >= 3;
  for (size_t i = 0; i < edges.size(); ++i) {
    const Vec3& a = edges[i];
    const Vec3& b = edges[(i + 1) % edges.size()];
    if (turn(a, b, point) < 0.0) result.is_inside = false;
    const Vec3 candidate = nearest_on_edge(horizontal(point), a, b);
    const double distance = (horizontal(point) - candidate).norm();
    if (distance < result.distance) {
      result.distance = distance;
      result.point = candidate;
    }
  }
  return result;
}

}  // namespace

std::vector<Vec3> Support::all() const {
  std::vector<Vec3> corners = left;
  corners.insert(corners.end(), right.begin(), right.end());
  corners.insert(corners.end(), elsewhere.begin(), elsewhere.end());
  return corners;
}

std::vector<Support> supports(const LintMotion& motion) {
  std::vector<Support> result(motion.world.size());
  const WeightBearing bears = weight_bearing_of(motion);
  const auto corners = [&](int t, bool left) {
    const SolePoints sole = sole_points(motion.clip.body, motion.world[t], left);
    return bearing_corners(sole, lowest_of(sole), motion.scale);
  };
  for (int t = 0; t < motion.frame_count(); ++t) {
    if (bears.left[t]) result[t].left = corners(t, true);
    if (bears.right[t]) result[t].right = corners(t, false);
    for (const BodyJoint joint : other_contacts(motion, t)) {
      result[t].elsewhere.push_back(horizontal(motion.world[t].positions[joint]));
    }
  }
  return result;
}

double signed_distance_to_hull(const Vec3& point, const std::vector<Vec3>& corners) {
  const Nearest found = nearest(point, corners);
  return found.is_inside ? -found.distance : found.distance;
}

Vec3 nearest_in_hull(const Vec3& point, const std::vector<Vec3>& corners) {
  const Nearest found = nearest(point, corners);
  return found.is_inside ? horizontal(point) : found.point;
}

BodyOnFloor body_on_floor(const LintMotion& motion) {
  return {body_dynamics(motion), supports(motion)};
}

void mask_ends(const LintMotion& motion, std::vector<double>& values) {
  if (motion.was_loop) return;
  const long count = static_cast<long>(values.size());
  const long ends = std::min(count, std::lround(0.1 * motion.rate()) + 1);
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  std::fill(values.begin(), values.begin() + ends, nothing);
  std::fill(values.end() - ends, values.end(), nothing);
}

}  // namespace mien::motion
