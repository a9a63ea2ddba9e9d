#include "motion/measures/distance/distance.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <vector>

#include "motion/math/rotation.h"
#include "motion/measures/distance/hand_tip_distance.h"
#include "motion/measures/distance/hands_distance.h"
#include "motion/skeleton/hand_tip.h"
#include "motion/skeleton/recorded_hands.h"

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

bool marks_match(const Example& a, const Example& b) {
  const auto goes_on = [](const Example& motion) {
    return motion.keytimes.size() >= 2 && motion.keytimes.back() > motion.keytimes.front();
  };
  return a.keytimes.size() == b.keytimes.size() && goes_on(a) && goes_on(b) &&
         a.keytimes != b.keytimes;
}

/// Keytimes half way between those of both motions, as shares of the duration, so that neither is
/// the other's measure. Empty where moments correspond by their share alone.
std::vector<double> shared_marks(const Example& a, const Example& b) {
  std::vector<double> marks;
  if (!marks_match(a, b)) return marks;
  const auto share = [](const Example& motion, size_t k) {
    const std::vector<double>& keytimes = motion.keytimes;
    return (keytimes[k] - keytimes.front()) / (keytimes.back() - keytimes.front());
  };
  for (size_t k = 0; k < a.keytimes.size(); ++k) marks.push_back(0.5 * (share(a, k) + share(b, k)));
  return marks;
}

double marked_time(const Example& motion, std::span<const double> marks, double share) {
  if (marks.empty()) return share * motion.clip.duration_seconds();
  return mapped(share, marks, motion.keytimes);
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
  if (!marks_match(timing, motion)) return share * motion.clip.duration_seconds();
  return mapped(from.front() + share * (from.back() - from.front()), from, to);
}

Distance distance(const Example& target, const Example& created, Alignment alignment) {
  assert(is_body(target.clip.body) && is_body(created.clip.body));
  const auto joints = [&](const Example& motion, double seconds) {
    return world_positions(motion.clip.body, aligned_pose_at(motion.clip, seconds, alignment));
  };
  const auto distances_at = [&](double of_target, double of_created) {
    return distances(joints(target, of_target), joints(created, of_created));
  };
  const std::vector<double> marks = shared_marks(target, created);

  Distance result;
  result.alignment = alignment;
  for (int t = 0; t < distance_times; ++t) {
    const double share = t / (distance_times - 1.0);
    result.by_joint_and_time.col(t) =
        distances_at(marked_time(target, marks, share), marked_time(created, marks, share));
  }
  result.sum = result.by_joint_and_time.sum();
  result.mean = result.sum / (distance_times * distance_joints);

  const int frames = target.clip.frame_count();
  const int last = target.clip.loops ? frames : std::max(1, frames - 1);
  for (int frame = 0; frame < frames; ++frame) {
    const double share = static_cast<double>(frame) / last;
    const double seconds = corresponding_time(target, created, share);
    result.mpjpe += distances_at(share * target.clip.duration_seconds(), seconds).mean() / frames;
  }
  return result;
}

double distance_with_hand_tips(const Example& target, const Example& created, Alignment alignment) {
  const std::vector<double> marks = shared_marks(target, created);
  double sum = distance(target, created, alignment).sum;
  for (int t = 0; t < distance_times; ++t) {
    const double share = t / (distance_times - 1.0);
    const Pose of_target =
        aligned_pose_at(target.clip, marked_time(target, marks, share), alignment);
    const Pose of_created =
        aligned_pose_at(created.clip, marked_time(created, marks, share), alignment);
    for (const bool left : {true, false}) {
      sum += (hand_tip(target.clip.body, of_target, left) -
              hand_tip(created.clip.body, of_created, left))
                 .norm();
    }
  }
  return sum / (distance_times * (distance_joints + 2));
}

std::optional<double> hands_distance(const Example& target, const Example& created) {
  if (!has_fingers(target.clip) || !has_fingers(created.clip)) return std::nullopt;
  const std::vector<double> marks = shared_marks(target, created);
  const auto tips = [&](const Example& motion, double share) {
    return fingertips(motion.clip.body, pose_at(motion.clip, marked_time(motion, marks, share)));
  };
  double sum = 0.0;
  for (int t = 0; t < distance_times; ++t) {
    const double share = t / (distance_times - 1.0);
    const auto of_target = tips(target, share);
    const auto of_created = tips(created, share);
    for (size_t tip = 0; tip < of_target.size(); ++tip)
      sum += (of_target[tip] - of_created[tip]).norm() / static_cast<double>(of_target.size());
  }
  return sum / distance_times;
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
