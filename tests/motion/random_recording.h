#pragma once

#include <algorithm>
#include <random>
#include <string>

#include "motion/math/rotation.h"
#include "motion/skeleton/recording.h"

namespace mien::test {

struct RandomRecordingOptions {
  int joints = 12;
  int frames = 20;
  double unit = 1.0;            ///< length of the longest offsets
  bool moving_offsets = false;  ///< some joints move on their parents
};

inline motion::Vec3 random_vector(std::mt19937_64& random, double size) {
  std::uniform_real_distribution<double> coordinate(-size, size);
  const double x = coordinate(random);
  const double y = coordinate(random);
  return {x, y, coordinate(random)};
}

/// A tree of joints in depth-first order; every leaf has a tip.
inline motion::Skeleton random_skeleton(std::mt19937_64& random, int count, double unit) {
  motion::Skeleton skeleton;
  std::vector<int> ancestors;
  for (int j = 0; j < count; ++j) {
    motion::Joint joint;
    joint.name = "joint " + std::to_string(j);
    joint.offset = random_vector(random, unit);
    if (j > 0) {
      const size_t keep = std::uniform_int_distribution<size_t>(1, ancestors.size())(random);
      ancestors.resize(keep);
      joint.parent = ancestors.back();
    }
    ancestors.push_back(j);
    skeleton.joints.push_back(joint);
  }
  const auto children = children_of(skeleton);
  for (int j = 0; j < count; ++j) {
    const auto joint = static_cast<size_t>(j);
    if (children[joint].empty()) skeleton.joints[joint].tip = random_vector(random, unit);
  }
  return skeleton;
}

/// Rotations of every size, unrelated from frame to frame.
inline motion::Recording random_recording(std::mt19937_64& random,
                                          const RandomRecordingOptions& options = {}) {
  motion::Recording recording;
  recording.name = "random";
  recording.skeleton = random_skeleton(random, options.joints, options.unit);
  recording.frames_per_second = std::uniform_int_distribution<int>(12, 240)(random);
  for (int f = 0; f < options.frames; ++f) {
    motion::Pose pose;
    pose.root_position = random_vector(random, 3.0 * options.unit);
    for (int j = 0; j < options.joints; ++j) {
      pose.rotations.push_back(motion::exp(random_vector(random, 1.8)));
      if (!options.moving_offsets) continue;
      const motion::Vec3& offset = recording.skeleton.joints[static_cast<size_t>(j)].offset;
      const bool moves = j > 0 && j % 3 == 0;
      pose.offsets.push_back(
          moves ? motion::Vec3(offset + random_vector(random, 0.1 * options.unit)) : offset);
    }
    recording.poses.push_back(pose);
  }
  return recording;
}

/// Largest distance between the same joints of two recordings, over all frames.
inline double largest_joint_distance(const motion::Recording& a, const motion::Recording& b) {
  double largest = 0.0;
  for (size_t f = 0; f < a.poses.size(); ++f) {
    const auto in_a = world_positions(a.skeleton, a.poses[f]);
    const auto in_b = world_positions(b.skeleton, b.poses[f]);
    for (size_t j = 0; j < in_a.size(); ++j) {
      largest = std::max(largest, (in_a[j] - in_b[j]).norm());
    }
  }
  return largest;
}

/// Largest angle between the same joints' rotations, radians.
inline double largest_turn(const motion::Recording& a, const motion::Recording& b) {
  double largest = 0.0;
  for (size_t f = 0; f < a.poses.size(); ++f) {
    for (size_t j = 0; j < a.poses[f].rotations.size(); ++j) {
      largest = std::max(largest,
                         motion::angle_between(a.poses[f].rotations[j], b.poses[f].rotations[j]));
    }
  }
  return largest;
}

/// Whether every number of the recording is finite and every rotation a unit quaternion.
inline bool is_sound(const motion::Recording& recording) {
  if (!is_well_formed(recording.skeleton) || recording.poses.empty()) return false;
  if (!(recording.frames_per_second > 0.0)) return false;
  const size_t joints = recording.skeleton.joints.size();
  return std::all_of(recording.poses.begin(), recording.poses.end(), [&](const motion::Pose& p) {
    if (p.rotations.size() != joints) return false;
    if (!p.offsets.empty() && p.offsets.size() != joints) return false;
    for (const motion::Quat& rotation : p.rotations) {
      if (!(std::abs(rotation.norm() - 1.0) < 1e-9)) return false;
    }
    for (const motion::Vec3& position : world_positions(recording.skeleton, p)) {
      if (!position.allFinite()) return false;
    }
    return true;
  });
}

}  // namespace mien::test
