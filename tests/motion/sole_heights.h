#pragma once

#include <algorithm>
#include <vector>

#include "motion/skeleton/sole.h"

namespace mien::test {

/// Height of the lowest point of both soles, frame by frame, metres.
inline std::vector<double> lowest_sole_heights(const motion::Clip& clip) {
  std::vector<double> heights;
  for (const motion::Pose& pose : clip.poses) {
    const motion::JointTransforms world = motion::world_transforms(clip.body, pose);
    heights.push_back(1e9);
    for (const bool left : {true, false}) {
      const motion::SolePoints points = motion::sole_points(clip.body, world, left);
      heights.back() = std::min({heights.back(), points.heel.y(), points.ball.y(), points.tip.y()});
    }
  }
  return heights;
}

}  // namespace mien::test
