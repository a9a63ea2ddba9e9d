#include "motion/fitting/feet_without_points.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "motion/math/filter.h"
#include "motion/math/percentile.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/pose.h"
#include "motion/skeleton/sole.h"

namespace mien::motion {

namespace {

constexpr double most_up = 40.0 * radians_per_degree;
constexpr double most_down = 75.0 * radians_per_degree;

BodyJoint ankle_of(bool left) { return left ? LeftAnkle : RightAnkle; }

std::vector<Vec3> ankle_path(const Clip& clip, bool left) {
  std::vector<Vec3> path;
  for (const Pose& pose : clip.poses)
    path.push_back(world_transform(clip.body, pose, ankle_of(left)).position);
  return path;
}

/// The foot flat on the floor, its toes forward by the axis of the knee.
Quat flat_foot(const Quat& shank) {
  Vec3 across = shank * Vec3::UnitX();
  across.y() = 0.0;
  if (across.norm() < 1e-6) return shank;
  return frame_from(across.normalized(), Vec3::UnitY());
}

/// How far the foot lies flat, 0 to 1, by its ankle's height above the one in standing.
double flatness(const Quat& shank, double above, double scale) {
  const double upright = std::clamp((shank * Vec3::UnitY()).y(), -1.0, 1.0);
  const double tilt = std::acos(upright) / radians_per_degree;
  return fade((above - 0.01 * scale) / (0.05 * scale)) * fade((tilt - 35.0) / 25.0);
}

/// A foot in one frame, to be turned about its own axis.
struct TurningFoot {
  const SoleShape& shape;
  Vec3 ankle;
  Quat rotation;

  /// Height of a point of the sole when the toes are turned up by an angle, radians.
  double height(const Vec3& point, double up) const {
    return (ankle + rotation * (exp(Vec3(-up, 0.0, 0.0)) * point)).y();
  }
};

/// The smallest angle towards `limit` at which a point is at `floor` or above; none if it never is.
std::optional<double> smallest_turn(const TurningFoot& foot, const Vec3& point, double floor,
                                    double from, double limit) {
  if (foot.height(point, from) >= floor) return from;
  if (foot.height(point, limit) < floor) return std::nullopt;
  double less = from;
  double more = limit;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (less + more);
    (foot.height(point, middle) < floor ? less : more) = middle;
  }
  return more;
}

/// By how much the toes must be turned up (negative: down) so that the foot is not in the floor.
double turn_out_of_floor(const TurningFoot& foot) {
  // An ankle that is lower than in standing takes the foot along.
  const double floor = std::min(0.0, foot.ankle.y() + foot.shape.ball.y());
  const auto up = smallest_turn(foot, foot.shape.ball, floor, 0.0, most_up);
  // Someone who kneels or lies on the front has the toes pointed.
  const auto down = smallest_turn(foot, foot.shape.ball, floor, 0.0, -most_down);
  const double turn = up ? *up : down.value_or(most_up);
  return smallest_turn(foot, foot.shape.heel, floor, turn, -most_down).value_or(turn);
}

/// The signal without what is faster than gait, within 0 and 1.
std::vector<double> smooth_shares(std::vector<double> shares, double rate) {
  shares = low_pass(shares, gait_cutoff_hz(rate), rate);
  for (double& share : shares) share = std::clamp(share, 0.0, 1.0);
  return shares;
}

/// Smooth turns that are nowhere less upward than the given ones, and hardly less downward.
std::vector<double> smooth_turns(const std::vector<double>& turns, double rate) {
  std::vector<double> up;
  std::vector<double> down;
  for (const double turn : turns) {
    up.push_back(std::max(turn, 0.0));
    down.push_back(std::min(turn, 0.0));
  }
  up = smooth_envelope(up, static_cast<int>(std::lround(0.04 * rate)), false);
  down = low_pass(down, 2.0 * gait_cutoff_hz(rate), rate);
  for (std::size_t frame = 0; frame < up.size(); ++frame) up[frame] += down[frame];
  return up;
}

void turn_ankles(Clip& clip, BodyJoint ankle, const std::vector<double>& up) {
  for (std::size_t frame = 0; frame < clip.poses.size(); ++frame) {
    Quat& rotation = clip.poses[frame].rotations[ankle];
    rotation = (rotation * exp(Vec3(-up[frame], 0.0, 0.0))).normalized();
  }
}

}  // namespace

double ankle_height_on_floor(const Skeleton& body, bool left) {
  return -sole_shape(body, left).ball.y();
}

void set_ankle_height(double height, bool left, Skeleton& body) {
  const double scale = relative_stature(body);
  const double set = std::clamp(height, 0.05 * scale, 0.10 * scale);
  body.joints[left ? LeftToe : RightToe].offset.y() = sole_depth(body) - set;
}

double standing_ankle_height(const Clip& clip, bool left) {
  constexpr double resting_speed = 0.3;  // m/s
  const std::vector<Vec3> path = ankle_path(clip, left);
  const double rate = clip.frames_per_second;
  const std::vector<Vec3> velocity = derivative(low_pass(path, gait_cutoff_hz(rate), rate), rate);
  std::vector<double> all;
  for (const Vec3& ankle : path) all.push_back(ankle.y());
  const double lowest = percentile(all, 3.0);
  std::vector<double> resting;
  for (std::size_t frame = 0; frame < path.size(); ++frame)
    if (velocity[frame].norm() < resting_speed &&
        path[frame].y() < lowest + 0.08 * relative_stature(clip.body))
      resting.push_back(path[frame].y());
  return resting.size() < 3 ? lowest : percentile(resting, 50.0);
}

void turn_foot_by_floor(Clip& clip, bool left) {
  const BodyJoint ankle = ankle_of(left);
  const BodyJoint knee = left ? LeftKnee : RightKnee;
  const SoleShape shape = sole_shape(clip.body, left);
  const double scale = relative_stature(clip.body);
  const double rate = clip.frames_per_second;
  const double standing = standing_ankle_height(clip, left);
  std::vector<Quat> shanks;
  std::vector<double> flat;
  for (const Pose& pose : clip.poses) {
    shanks.push_back(world_transform(clip.body, pose, knee).rotation);
    const double above = world_transform(clip.body, pose, ankle).position.y() - standing;
    flat.push_back(flatness(shanks.back(), above, scale));
  }
  flat = smooth_shares(std::move(flat), rate);
  std::vector<double> turns;
  for (std::size_t frame = 0; frame < clip.poses.size(); ++frame) {
    Pose& pose = clip.poses[frame];
    const JointTransform foot = world_transform(clip.body, pose, ankle);
    const Quat rotation = slerp(foot.rotation, flat_foot(shanks[frame]), flat[frame]);
    pose.rotations[ankle] = (shanks[frame].conjugate() * rotation).normalized();
    turns.push_back(turn_out_of_floor({shape, foot.position, rotation}));
  }
  turn_ankles(clip, ankle, smooth_turns(turns, rate));
}

}  // namespace mien::motion
