#include "scenes/figures/figure.h"

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

const FigureKind& kind_of(const Figure& figure) {
  return std::visit([](const auto& options) -> const FigureKind& { return options.kind; }, figure);
}

const std::filesystem::path* file_of(const Figure& figure) {
  const auto file = []<class Options>(const Options& options) -> const std::filesystem::path* {
    if constexpr (FromFile<Options>) return &options.file;
    return nullptr;
  };
  const auto* trail = std::get_if<TrailOptions>(&figure);
  return trail != nullptr ? std::visit(file, trail->figure) : std::visit(file, figure);
}

}  // namespace mien::scenes
