#include "motion/motion_graph/point_cloud.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mien::motion {

namespace {

/// A point off the bone that a joint carries, in the joint's frame.
Vec3 virtual_point(BodyJoint joint, double metres) {
  const Vec3 bone = rest_direction(joint);
  const Vec3 other = std::abs(bone.z()) < 0.7 ? Vec3::UnitZ() : Vec3::UnitX();
  return metres * (other - other.dot(bone) * bone).normalized();
}

}  // namespace

PointCloud point_cloud(const Clip& clip, const CloudOptions& options) {
  constexpr int points = 2 * body_joint_count;
  const auto& weights = options.joint_weights;
  const double sum = 2.0 * std::accumulate(weights.begin(), weights.end(), 0.0);
  const int frames = clip.frame_count();
  PointCloud cloud;
  cloud.level.resize(2 * points, frames);
  cloud.across.resize(2 * points, frames);
  cloud.up.resize(points, frames);
  cloud.mean = Eigen::MatrixXd::Zero(2, frames);
  cloud.square = Eigen::VectorXd::Zero(frames);
  for (int f = 0; f < frames; ++f) {
    const JointTransforms world =
        world_transforms(clip.body, clip.poses[static_cast<std::size_t>(f)]);
    for (int p = 0; p < points; ++p) {
      const auto joint = static_cast<std::size_t>(p / 2);
      const double weight = weights[joint] / sum;
      Vec3 place = world.positions[joint];
      if (p % 2 == 1) {
        place += world.rotations[joint] * virtual_point(BodyJoint(p / 2), options.virtual_point_m);
      }
      const Vec3 scaled = std::sqrt(weight) * place;
      cloud.level(p, f) = cloud.across(points + p, f) = scaled.x();
      cloud.level(points + p, f) = cloud.across(p, f) = scaled.z();
      cloud.across(points + p, f) *= -1.0;
      cloud.up(p, f) = scaled.y();
      cloud.mean(0, f) += weight * place.x();
      cloud.mean(1, f) += weight * place.z();
      cloud.square[f] += weight * place.squaredNorm();
    }
  }
  return cloud;
}

Vec3 aligned(const PlaneAlignment& alignment, const Vec3& place) {
  return Quat(Eigen::AngleAxisd(alignment.turn, Vec3::UnitY())) * place +
         Vec3(alignment.x, 0.0, alignment.z);
}

WindowDistance window_distance(const PointCloud& a, int first_a, const PointCloud& b, int first_b,
                               int frames) {
  double along = 0.0;
  double turned = 0.0;
  double up = 0.0;
  for (int f = 0; f < frames; ++f) {
    along += a.level.col(first_a + f).dot(b.level.col(first_b + f));
    turned += a.level.col(first_a + f).dot(b.across.col(first_b + f));
    up += a.up.col(first_a + f).dot(b.up.col(first_b + f));
  }
  const double share = 1.0 / frames;
  const Eigen::Vector2d middle_a = share * a.mean.middleCols(first_a, frames).rowwise().sum();
  const Eigen::Vector2d middle_b = share * b.mean.middleCols(first_b, frames).rowwise().sum();
  along = share * along - middle_a.dot(middle_b);
  turned = share * turned - (middle_a.x() * middle_b.y() - middle_a.y() * middle_b.x());
  const double squares =
      share * (a.square.segment(first_a, frames).sum() + b.square.segment(first_b, frames).sum()) -
      middle_a.squaredNorm() - middle_b.squaredNorm() - 2.0 * share * up;
  WindowDistance distance;
  distance.metres = std::sqrt(std::max(0.0, squares - 2.0 * std::hypot(along, turned)));
  distance.alignment.turn = std::atan2(turned, along);
  const Vec3 moved =
      aligned({distance.alignment.turn, 0.0, 0.0}, Vec3(middle_b.x(), 0.0, middle_b.y()));
  distance.alignment.x = middle_a.x() - moved.x();
  distance.alignment.z = middle_a.y() - moved.z();
  return distance;
}

}  // namespace mien::motion
