#include "motion/sole.h"

namespace mien::motion {

SolePoints sole_points(const Skeleton& body, const JointTransforms& world, bool left) {
  const BodyJoint ankle = left ? LeftAnkle : RightAnkle;
  const BodyJoint toe = left ? LeftToe : RightToe;
  const double scale = standing_height(body) / 1.73;  // 1.75 m less the 0.02 m below the toe joint
  const Vec3 ball = body.joints[toe].offset - Vec3(0.0, 0.02 * scale, 0.0);
  const Vec3 heel(ball.x(), ball.y(), -0.045 * scale);
  const Vec3 toes = body.joints[toe].tip.value_or(Vec3(0.0, 0.0, 0.06 * scale));
  const Vec3 tip = toes - Vec3(0.0, 0.02 * scale, 0.0);
  return {world.positions[ankle] + world.rotations[ankle] * heel,
          world.positions[ankle] + world.rotations[ankle] * ball,
          world.positions[toe] + world.rotations[toe] * tip};
}

std::vector<SolePoints> sole_paths(const Clip& clip, bool left) {
  std::vector<SolePoints> path;
  path.reserve(clip.poses.size());
  for (const Pose& pose : clip.poses) {
    path.push_back(sole_points(clip.body, world_transforms(clip.body, pose), left));
  }
  return path;
}

}  // namespace mien::motion
