#include "motion/skeleton/sole.h"

#include "motion/skeleton/joint_transform.h"

namespace mien::motion {

namespace {

/// The points of one foot in the frames of its joints.
struct SoleShape {
  Vec3 heel;  ///< in the ankle's frame
  Vec3 ball;  ///< in the ankle's frame
  Vec3 tip;   ///< in the toe joint's frame
};

SoleShape sole_shape(const Skeleton& body, bool left) {
  const BodyJoint toe = left ? LeftToe : RightToe;
  const double scale = standing_height(body) / 1.73;  // 1.75 m less the 0.02 m below the toe joint
  SoleShape shape;
  shape.ball = body.joints[toe].offset - Vec3(0.0, 0.02 * scale, 0.0);
  shape.heel = Vec3(shape.ball.x(), shape.ball.y(), -0.045 * scale);
  const Vec3 toes = body.joints[toe].tip.value_or(Vec3(0.0, 0.0, 0.06 * scale));
  shape.tip = toes - Vec3(0.0, 0.02 * scale, 0.0);
  return shape;
}

SolePoints placed(const SoleShape& shape, const JointTransform& ankle, const JointTransform& toe) {
  return {ankle.position + ankle.rotation * shape.heel,
          ankle.position + ankle.rotation * shape.ball, toe.position + toe.rotation * shape.tip};
}

}  // namespace

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
