#include "motion/floor.h"

#include <algorithm>
#include <array>

#include "motion/percentile.h"

namespace mien::motion {

namespace {

constexpr int points_per_foot = 3;
using FootPoints = std::array<Vec3, 2 * points_per_foot>;

FootPoints foot_points(const Skeleton& body, const Pose& pose) {
  const JointTransforms world = world_transforms(body, pose);
  FootPoints points;
  int next = 0;
  for (const BodyJoint ankle : {LeftAnkle, RightAnkle}) {
    const auto toe = BodyJoint(ankle + 1);
    points[next++] = world.positions[ankle];
    points[next++] = world.positions[toe];
    points[next++] =
        world.positions[toe] + world.rotations[toe] * body.joints[toe].tip.value_or(Vec3::Zero());
  }
  return points;
}

size_t lowest(const FootPoints& points) {
  const auto by_height = [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); };
  return static_cast<size_t>(std::min_element(points.begin(), points.end(), by_height) -
                             points.begin());
}

}  // namespace

std::vector<double> lowest_foot_heights(const Clip& clip) {
  std::vector<double> heights;
  for (const Pose& pose : clip.poses) {
    const FootPoints points = foot_points(clip.body, pose);
    heights.push_back(points[lowest(points)].y());
  }
  return heights;
}

double floor_height(const Clip& clip) {
  std::vector<FootPoints> points;
  for (const Pose& pose : clip.poses) points.push_back(foot_points(clip.body, pose));
  std::vector<double> all;
  std::vector<double> resting;
  for (size_t t = 0; t < points.size(); ++t) {
    const size_t low = lowest(points[t]);
    all.push_back(points[t][low].y());
    if (t == 0) continue;
    const double speed = (points[t][low] - points[t - 1][low]).norm() * clip.frames_per_second;
    if (speed < 0.3) resting.push_back(all.back());
  }
  return percentile(resting.size() > 2 ? resting : all, 3);
}

}  // namespace mien::motion
