#include "scenes/figures/figure.h"

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

std::string_view name_of(const Figure& figure) { return std::visit(Naming{}, figure); }

const CharacterOptions* character_in(const Figure& figure) {
  if (const auto* trail = std::get_if<TrailOptions>(&figure)) {
    return std::get_if<CharacterOptions>(&trail->figure);
  }
  return std::get_if<CharacterOptions>(&figure);
}

}  // namespace mien::scenes
