#include "scenes/figures/figure.h"

#include <algorithm>

#include "motion/skeleton/body.h"

namespace mien::scenes {

namespace {

struct Naming {
  std::string_view operator()(const StickOptions&) const { return "stick"; }
  std::string_view operator()(const MannequinOptions&) const { return "mannequin"; }
  std::string_view operator()(const CharacterOptions&) const { return "character"; }
  std::string_view operator()(const PointLightOptions&) const { return "point-light"; }
  std::string_view operator()(const TrailOptions&) const { return "trail"; }
};

}  // namespace

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

std::string_view name_of(const Figure& figure) { return std::visit(Naming{}, figure); }

const CharacterOptions* character_in(const Figure& figure) {
  if (const auto* trail = std::get_if<TrailOptions>(&figure)) {
    return std::get_if<CharacterOptions>(&trail->figure);
  }
  return std::get_if<CharacterOptions>(&figure);
}

}  // namespace mien::scenes
