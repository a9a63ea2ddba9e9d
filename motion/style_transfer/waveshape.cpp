#include "motion/style_transfer/waveshape.h"

#include <cmath>
#include <string>

#include "motion/error.h"
#include "motion/interpolation/time_warp.h"
#include "motion/style_transfer/motion_curves.h"

namespace mien::motion {

namespace {

constexpr double least_swing = 1.0 * radians_per_degree;

void require_shape(const JointWaveshape& joint) {
  const Waveshape& shape = joint.shape;
  const std::string whose = "the wave shape of " + std::string(name_of(joint.joint));
  if (shape.points.empty()) {
    if (shape.lower > shape.upper) {
      throw Error(whose + " has its lower limit above its upper one", "exchange them");
    }
    if (shape.softness < 0.0) {
      throw Error(whose + " has a negative softness", "give 0 for a hard limit, or more");
    }
    return;
  }
  if (shape.points.size() < 2) {
    throw Error(whose + " has a single point", "give at least two");
  }
  for (size_t k = 1; k < shape.points.size(); ++k) {
    if (shape.points[k].first <= shape.points[k - 1].first) {
      throw Error(whose + " has points that are not in ascending order",
                  "sort them by the first number");
    }
  }
}

/// Softly limited excess beyond a limit, for `excess` ≥ 0.
double softened(double excess, double softness) {
  if (softness <= 0.0) return 0.0;
  return -softness * std::expm1(-excess / softness);
}

double through_points(const std::vector<std::pair<double, double>>& points, double angle) {
  const auto straight = [&](size_t from, size_t to) {
    const double slope =
        (points[to].second - points[from].second) / (points[to].first - points[from].first);
    return points[from].second + slope * (angle - points[from].first);
  };
  if (angle <= points.front().first) return straight(0, 1);
  if (angle >= points.back().first) return straight(points.size() - 1, points.size() - 2);
  std::vector<double> from;
  std::vector<double> to;
  for (const auto& [x, y] : points) {
    from.push_back(x);
    to.push_back(y);
  }
  return warped(make_time_warp(from, to, WarpShape::monotone, false), angle);
}

double root_mean_square(const MotionCurves& curves, int joint) {
  return std::sqrt(curves.values.middleCols<3>(first_curve(joint)).rowwise().squaredNorm().mean());
}

}  // namespace

double shaped(const Waveshape& shape, double angle) {
  if (!shape.points.empty()) return through_points(shape.points, angle);
  if (angle > shape.upper) return shape.upper + softened(angle - shape.upper, shape.softness);
  if (angle < shape.lower) return shape.lower - softened(shape.lower - angle, shape.softness);
  return angle;
}

Clip waveshaped(const Clip& motion, const std::vector<JointWaveshape>& shapes,
                const WaveshapeOptions& options) {
  MotionCurves curves = to_curves(motion);
  for (const JointWaveshape& joint : shapes) {
    require_shape(joint);
    for (int i = 0; i < curves.frame_count(); ++i) {
      auto cell = curves.values.block<1, 3>(i, first_curve(joint.joint));
      const Vec3 vector = cell.transpose();
      const Vec3 axis = joint.axis ? joint.axis->normalized() : vector.normalized();
      const double angle = vector.dot(axis);
      cell += options.amount * (shaped(joint.shape, angle) - angle) * axis.transpose();
    }
  }
  return to_clip(curves);
}

std::vector<JointWaveshape> shapes_between(const Clip& neutral, const Clip& styled) {
  const MotionCurves from = to_curves(neutral);
  const MotionCurves to = to_curves(styled);
  std::vector<JointWaveshape> shapes;
  for (int joint = 0; joint < body_joint_count; ++joint) {
    const double swing = root_mean_square(from, joint);
    if (swing < least_swing) continue;
    const double slope = root_mean_square(to, joint) / swing;
    JointWaveshape shape;
    shape.joint = BodyJoint(joint);
    shape.shape.points = {{-1.0, -slope}, {1.0, slope}};
    shapes.push_back(shape);
  }
  return shapes;
}

}  // namespace mien::motion
