#include "motion/gait/foot_path.h"

#include <algorithm>
#include <limits>

#include "motion/skeleton/pose.h"
#include "motion/skeleton/sole.h"

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
  path.sole_depth = sole_depth(clip.body);
  path.loops = clip.loops;
  path.cycle_displacement = clip.cycle_displacement;
  path.ankle.reserve(clip.poses.size());
  path.rotation.reserve(clip.poses.size());
  for (const Pose& pose : clip.poses) {
    const JointTransform ankle = world_transform(clip.body, pose, leg.ankle);
    path.ankle.push_back(ankle.position);
    path.rotation.push_back(ankle.rotation);
  }
  return path;
}

Stance stance_of(const FootPath& path, const FootPlant& plant, double flat_metres,
                 double lifted_metres) {
  double lowest_ball = std::numeric_limits<double>::infinity();
  double lowest_heel = std::numeric_limits<double>::infinity();
  for (int f = plant.first; f <= plant.last; ++f) {
    lowest_ball = std::min(lowest_ball, path.ball_at(f).y());
    lowest_heel = std::min(lowest_heel, path.heel_at(f).y());
  }
  const auto lift = [&](int f) {
    return std::max(path.ball_at(f).y() - lowest_ball, path.heel_at(f).y() - lowest_heel);
  };
  double flattest = std::numeric_limits<double>::infinity();
  for (int f = plant.first; f <= plant.last; ++f) flattest = std::min(flattest, lift(f));
  Stance stance{plant.first, plant.last + 1, plant.first - 1, plant.last};
  for (int f = plant.first; f <= plant.last; ++f) {
    if (lift(f) > std::max(flat_metres, flattest)) continue;
    stance.flat_first = std::min(stance.flat_first, f);
    stance.flat_last = std::max(stance.flat_last, f);
  }
  const double ball_level = path.ball_at(stance.flat_last).y();
  const double heel_level = path.heel_at(stance.flat_first).y();
  for (stance.last = stance.flat_last; stance.last < plant.last; ++stance.last) {
    if (path.ball_at(stance.last + 1).y() > ball_level + lifted_metres) break;
  }
  for (stance.first = stance.flat_first; stance.first > plant.first; --stance.first) {
    if (path.heel_at(stance.first - 1).y() > heel_level + lifted_metres) break;
  }
  return stance;
}

}  // namespace mien::motion
