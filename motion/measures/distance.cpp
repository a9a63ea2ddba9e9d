#include "motion/measures/distance.h"

#include <algorithm>
#include <cassert>
#include <span>

#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

using JointDistances = Eigen::Vector<double, distance_joints>;

JointDistances distances(std::span<const Vec3> from, std::span<const Vec3> to) {
  JointDistances result;
  for (int j = 0; j < distance_joints; ++j) {
    const auto joint = static_cast<size_t>(j + 1);  // 0 is the pelvis
    result[j] = (from[joint] - to[joint]).norm();
  }
  return result;
}

/// Seconds → seconds, linear between matching marks.
double mapped(double seconds, std::span<const double> from, std::span<const double> to) {
  size_t k = 1;
  while (k + 1 < from.size() && seconds > from[k]) ++k;
  const double t = (seconds - from[k - 1]) / (from[k] - from[k - 1]);
  return (1.0 - t) * to[k - 1] + t * to[k];
}

}  // namespace

Pose aligned_pose_at(const Clip& clip, double seconds, Alignment alignment) {
  Pose pose = pose_at(clip, seconds);
  const Pose& seen_from = alignment == Alignment::pelvis ? pose : clip.poses.front();
  const Vec3 origin(seen_from.root_position.x(), 0.0, seen_from.root_position.z());
  const Quat facing = heading(seen_from.rotations[0] * Vec3::UnitZ());
  pose.root_position = facing.conjugate() * (pose.root_position - origin);
  pose.rotations[0] = facing.conjugate() * pose.rotations[0];
  return pose;
}

double corresponding_time(const Example& timing, const Example& motion, double share) {
  const auto& from = timing.keytimes;
  const auto& to = motion.keytimes;
  if (from.size() != to.size() || from.size() < 2 || from == to) {
    return share * motion.clip.duration_seconds();
  }
  return mapped(from.front() + share * (from.back() - from.front()), from, to);
}

Distance distance(const Example& target, const Example& created, Alignment alignment) {
  assert(is_body(target.clip.body) && is_body(created.clip.body));
  const auto joints = [&](const Example& motion, double share) {
    const double seconds = corresponding_time(target, motion, share);
    return world_positions(motion.clip.body, aligned_pose_at(motion.clip, seconds, alignment));
  };
  const auto distances_at = [&](double share) {
    return distances(joints(target, share), joints(created, share));
  };

  Distance result;
  result.alignment = alignment;
  for (int t = 0; t < distance_times; ++t) {
    result.by_joint_and_time.col(t) = distances_at(t / (distance_times - 1.0));
  }
  result.sum = result.by_joint_and_time.sum();
  result.mean = result.sum / (distance_times * distance_joints);

  const int frames = target.clip.frame_count();
  const int last = target.clip.loops ? frames : std::max(1, frames - 1);
  for (int frame = 0; frame < frames; ++frame) {
    result.mpjpe += distances_at(static_cast<double>(frame) / last).mean() / frames;
  }
  return result;
}

std::array<double, distance_joints> Distance::by_joint() const {
  std::array<double, distance_joints> means;
  for (int j = 0; j < distance_joints; ++j) {
    means[static_cast<size_t>(j)] = by_joint_and_time.row(j).mean();
  }
  return means;
}

std::array<double, distance_times> Distance::by_time() const {
  std::array<double, distance_times> means;
  for (int t = 0; t < distance_times; ++t) {
    means[static_cast<size_t>(t)] = by_joint_and_time.col(t).mean();
  }
  return means;
}

}  // namespace mien::motion
