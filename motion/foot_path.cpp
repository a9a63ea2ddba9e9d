#include "motion/foot_path.h"

#include <algorithm>
#include <limits>

namespace mien::motion {

namespace {

/// The heel lies about a third as far behind the ankle as the ball lies before it.
constexpr double heel_share = 0.35;

}  // namespace

LegJoints leg_joints(bool left) {
  if (left) return {LeftHip, LeftKnee, LeftAnkle, LeftToe};
  return {RightHip, RightKnee, RightAnkle, RightToe};
}

int FootPath::wrapped(int frame) const {
  const int count = frame_count();
  return loops ? ((frame % count) + count) % count : std::clamp(frame, 0, count - 1);
}

Vec3 FootPath::displacement(int frame) const {
  if (!loops) return Vec3::Zero();
  const int cycles = (frame - wrapped(frame)) / frame_count();
  return cycles * cycle_displacement;
}

Vec3 FootPath::ankle_at(int frame) const {
  return ankle[static_cast<size_t>(wrapped(frame))] + displacement(frame);
}

Quat FootPath::rotation_at(int frame) const {
  return rotation[static_cast<size_t>(wrapped(frame))];
}

Vec3 FootPath::ball_at(int frame) const {
  return ankle_at(frame) + rotation_at(frame) * ball_in_foot;
}

Vec3 FootPath::heel_at(int frame) const {
  return ankle_at(frame) + rotation_at(frame) * heel_in_foot;
}

FootPath foot_path(const Clip& clip, bool left) {
  const LegJoints leg = leg_joints(left);
  FootPath path;
  path.ball_in_foot = clip.body.joints[static_cast<size_t>(leg.toe)].offset;
  path.heel_in_foot =
      Vec3(0.0, path.ball_in_foot.y(), -heel_share * std::abs(path.ball_in_foot.z()));
  path.loops = clip.loops;
  path.cycle_displacement = clip.cycle_displacement;
  for (const Pose& pose : clip.poses) {
    const JointTransforms world = world_transforms(clip.body, pose);
    path.ankle.push_back(world.positions[static_cast<size_t>(leg.ankle)]);
    path.rotation.push_back(world.rotations[static_cast<size_t>(leg.ankle)]);
  }
  return path;
}

FlatSole flat_sole(const FootPath& path, const FootPlant& plant, double tolerance_metres) {
  double lowest_ball = std::numeric_limits<double>::infinity();
  double lowest_heel = lowest_ball;
  for (int f = plant.first; f <= plant.last; ++f) {
    lowest_ball = std::min(lowest_ball, path.ball_at(f).y());
    lowest_heel = std::min(lowest_heel, path.heel_at(f).y());
  }
  // A heel that stays well above the ball never comes down: running on the toes.
  if (lowest_heel > lowest_ball + 2.0 * tolerance_metres) return {};
  FlatSole flat{plant.last + 1, plant.first - 1};
  for (int f = plant.first; f <= plant.last; ++f) {
    const bool on_floor = path.ball_at(f).y() < lowest_ball + tolerance_metres &&
                          path.heel_at(f).y() < lowest_heel + tolerance_metres;
    if (!on_floor) continue;
    flat.first = std::min(flat.first, f);
    flat.last = std::max(flat.last, f);
  }
  return flat;
}

}  // namespace mien::motion
