#include "motion/skeleton/sole.h"

#include "motion/skeleton/pose.h"

namespace mien::motion {

namespace {

SolePoints placed(const SoleShape& shape, const JointTransform& ankle, const JointTransform& toe) {
  const Vec3 tip = shape.toes - Vec3(0.0, shape.depth, 0.0);
  return {ankle.position + ankle.rotation * shape.heel,
          ankle.position + ankle.rotation * shape.ball, toe.position + toe.rotation * tip};
}

}  // namespace

double sole_depth(const Skeleton& body) { return 0.02 * relative_stature(body); }

SoleShape sole_shape(const Skeleton& body, bool left) {
  const Joint& toe = body.joints[left ? LeftToe : RightToe];
  const double scale = relative_stature(body);
  SoleShape shape;
  shape.depth = sole_depth(body);
  shape.ball = toe.offset - Vec3(0.0, shape.depth, 0.0);
  shape.heel = Vec3(shape.ball.x(), shape.ball.y(), -0.045 * scale);
  shape.toes = toe.tip.value_or(Vec3(0.0, 0.0, 0.06 * scale));
  return shape;
}

SolePoints sole_points(const Skeleton& body, const JointTransforms& world, bool left) {
  const BodyJoint ankle = left ? LeftAnkle : RightAnkle;
  const BodyJoint toe = left ? LeftToe : RightToe;
  return placed(sole_shape(body, left), {world.positions[ankle], world.rotations[ankle]},
                {world.positions[toe], world.rotations[toe]});
}

std::vector<SolePoints> sole_paths(const Clip& clip, bool left) {
  const BodyJoint ankle = left ? LeftAnkle : RightAnkle;
  const BodyJoint toe = left ? LeftToe : RightToe;
  const SoleShape shape = sole_shape(clip.body, left);
  std::vector<SolePoints> path;
  path.reserve(clip.poses.size());
  for (const Pose& pose : clip.poses) {
    path.push_back(placed(shape, world_transform(clip.body, pose, ankle),
                          world_transform(clip.body, pose, toe)));
  }
  return path;
}

}  // namespace mien::motion
