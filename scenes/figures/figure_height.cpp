#include "scenes/figures/figure_height.h"

#include <algorithm>

#include "motion/skeleton/body.h"

namespace mien::scenes {

double figure_height(const motion::Clip& clip) {
  if (motion::is_body(clip.body)) return motion::standing_height(clip.body);
  const motion::JointTransforms world = motion::world_transforms(clip.body, clip.poses.front());
  double height = 0.0;
  const auto reach = [&](const motion::Vec3& point) {
    height = std::max(height, (point - world.positions.front()).norm());
  };
  for (size_t j = 0; j < world.positions.size(); ++j) {
    reach(world.positions[j]);
    const auto& tip = clip.body.joints[j].tip;
    if (tip) reach(world.positions[j] + world.rotations[j] * *tip);
  }
  return std::max(height, 0.2);
}

}  // namespace mien::scenes
