#include "motion/rig/toe_bend.h"

#include <algorithm>

#include "motion/math/rotation.h"
#include "motion/skeleton/pose.h"
#include "motion/skeleton/sole.h"

namespace mien::motion {

namespace {

constexpr double most_degrees = 70.0;
constexpr int halvings = 24;

}  // namespace

void bend_toes_at_floor(Clip& clip, BodyJoint toe) {
  const SoleShape shape = sole_shape(clip.body, toe == LeftToe);
  const Vec3 tip = shape.toes - Vec3(0.0, shape.depth, 0.0);
  for (Pose& pose : clip.poses) {
    const JointTransform stiff = world_transform(clip.body, pose, toe);
    const auto height = [&](double bend) {
      return (stiff.position + stiff.rotation * exp(Vec3(-bend, 0.0, 0.0)) * tip).y();
    };
    // A ball that is in the floor takes the toes along.
    const double ball = (stiff.position - stiff.rotation * Vec3(0.0, shape.depth, 0.0)).y();
    const double wanted = std::min(ball, 0.0);
    if (height(0.0) >= wanted) continue;
    double less = 0.0;
    double more = most_degrees * radians_per_degree;
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (less + more);
      (height(middle) < wanted ? less : more) = middle;
    }
    pose.rotations[toe] = (pose.rotations[toe] * exp(Vec3(-more, 0.0, 0.0))).normalized();
  }
}

}  // namespace mien::motion
