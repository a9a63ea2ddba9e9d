#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::test {

/// Metres that a joint moves relative to the pelvis, from frame to frame; around a loop's seam too.
inline std::vector<double> joint_steps(const motion::Clip& clip, motion::BodyJoint joint) {
  const auto paths = motion::joint_paths(clip);
  const auto at = [&](std::size_t f) {
    return motion::Vec3(paths[f][static_cast<std::size_t>(joint)] - paths[f][motion::Pelvis]);
  };
  std::vector<double> steps;
  for (std::size_t f = 1; f < paths.size(); ++f) steps.push_back((at(f) - at(f - 1)).norm());
  if (clip.loops) steps.push_back((at(0) - at(paths.size() - 1)).norm());
  return steps;
}

inline double path_length(const motion::Clip& clip, motion::BodyJoint joint) {
  double sum = 0.0;
  for (const double step : joint_steps(clip, joint)) sum += step;
  return sum;
}

/// Coefficient of variation of the joint's speed relative to the pelvis.
inline double speed_variation(const motion::Clip& clip, motion::BodyJoint joint) {
  const std::vector<double> steps = joint_steps(clip, joint);
  double mean = 0.0;
  for (const double step : steps) mean += step / static_cast<double>(steps.size());
  double variance = 0.0;
  for (const double step : steps) {
    variance += (step - mean) * (step - mean) / static_cast<double>(steps.size());
  }
  return std::sqrt(variance) / mean;
}

/// Largest distance between the same joints of two clips, metres.
inline double largest_distance(const motion::Clip& a, const motion::Clip& b) {
  const auto first = motion::joint_paths(a);
  const auto second = motion::joint_paths(b);
  if (first.size() != second.size()) return INFINITY;
  double largest = 0.0;
  for (std::size_t f = 0; f < first.size(); ++f) {
    for (std::size_t j = 0; j < first[f].size(); ++j) {
      largest = std::max(largest, (first[f][j] - second[f][j]).norm());
    }
  }
  return largest;
}

/// Largest second difference of any joint's place, metres a frame²: what pops is seen here. Goes
/// over the seam of a loop.
inline double largest_second_difference(const motion::Clip& clip) {
  const auto paths = motion::joint_paths(clip.loops ? motion::repeated(clip, 2) : clip);
  double largest = 0.0;
  for (std::size_t f = 2; f < paths.size(); ++f) {
    for (std::size_t j = 0; j < paths[f].size(); ++j) {
      largest = std::max(largest, (paths[f][j] - 2.0 * paths[f - 1][j] + paths[f - 2][j]).norm());
    }
  }
  return largest;
}

}  // namespace mien::test
