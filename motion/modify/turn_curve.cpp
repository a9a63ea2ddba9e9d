#include "motion/modify/turn_curve.h"

#include <cmath>

#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

Quat mean_rotation(const Clip& clip, size_t joint) {
  Quat mean = clip.poses[clip.poses.size() / 2].rotations[joint];
  for (int iteration = 0; iteration < 4; ++iteration) {
    Vec3 step = Vec3::Zero();
    for (const Pose& pose : clip.poses) step += log(mean.conjugate() * pose.rotations[joint]);
    mean = (mean * exp(step / clip.frame_count())).normalized();
  }
  return mean;
}

/// The rotation vector that means the same turn as `turn` and lies nearest to `previous`.
Vec3 unwound(const Vec3& turn, const Vec3& previous) {
  const double angle = turn.norm();
  if (angle < 1e-9) return turn;
  const double rounds = std::round((previous.dot(turn) / angle - angle) / (2.0 * pi));
  return turn * (1.0 + 2.0 * pi * rounds / angle);
}

}  // namespace

TurnCurve turn_curve(const Clip& clip, int joint) {
  const auto at = static_cast<size_t>(joint);
  TurnCurve curve{mean_rotation(clip, at), {}};
  Vec3 previous = Vec3::Zero();
  for (const Pose& pose : clip.poses) {
    previous = unwound(log(curve.mean.conjugate() * pose.rotations[at]), previous);
    curve.turns.push_back(previous);
  }
  return curve;
}

void set_rotations(Clip& clip, int joint, const TurnCurve& curve) {
  const auto at = static_cast<size_t>(joint);
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    Quat& rotation = clip.poses[f].rotations[at];
    rotation = in_hemisphere_of(rotation, (curve.mean * exp(curve.turns[f])).normalized());
  }
}

}  // namespace mien::motion
