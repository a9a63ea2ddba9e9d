#pragma once

#include <algorithm>
#include <vector>

#include "motion/motion_graph/motion_graph.h"
#include "motion/walker_motions.h"

namespace mien::motion::test {

/// What the walker does, on the standard body.
inline const std::vector<Clip>& made_motions() {
  static const std::vector<Clip> clips = walker_motions(WalkStyle{}, 30.0, standard_body());
  return clips;
}

inline const MotionGraph& made_graph() {
  static const MotionGraph graph = motion_graph(made_motions());
  return graph;
}

/// The clip turned and shifted over the floor.
inline Clip moved(Clip clip, double turn, const Vec3& shift) {
  const Quat turned(Eigen::AngleAxisd(turn, Vec3::UnitY()));
  for (Pose& pose : clip.poses) {
    pose.root_position = turned * pose.root_position + shift;
    pose.rotations.front() = turned * pose.rotations.front();
  }
  return clip;
}

/// Largest acceleration of a joint, m/s².
inline double largest_acceleration(const Clip& clip) {
  const std::vector<std::vector<Vec3>> paths = joint_paths(clip);
  const double rate = clip.frames_per_second * clip.frames_per_second;
  double largest = 0.0;
  for (std::size_t i = 1; i + 1 < paths.size(); ++i) {
    for (std::size_t j = 0; j < paths[i].size(); ++j) {
      const Vec3 bend = paths[i + 1][j] - 2.0 * paths[i][j] + paths[i - 1][j];
      largest = std::max(largest, bend.norm() * rate);
    }
  }
  return largest;
}

}  // namespace mien::motion::test
