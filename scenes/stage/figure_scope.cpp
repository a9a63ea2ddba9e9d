#include "scenes/stage/figure_scope.h"

namespace mien::scenes {

namespace {

/// Solids from index `first` on that name no part of their own become part `body`.
template <class Solids>
void give_part(Solids& solids, std::size_t first, int body) {
  for (std::size_t i = first; i < solids.size(); ++i) {
    if (solids[i].part == 0) solids[i].part = body;
  }
}

}  // namespace

void draw_as_figure(render::Scene& scene, const std::string& name, float opacity,
                    const std::function<void()>& draw) {
  if (!scene.solids.empty()) {
    scene.figures.emplace_back();
    scene.parts.push_back({"body", static_cast<int>(scene.figures.size()) - 1});
  }
  const auto figure = static_cast<int>(scene.figures.size()) - 1;
  const auto body = static_cast<int>(scene.parts.size()) - 1;
  scene.figures.back() = {name, opacity};
  const std::size_t spheres = scene.solids.spheres.size();
  const std::size_t round_cones = scene.solids.round_cones.size();
  const std::size_t meshes = scene.solids.meshes.size();
  draw();
  for (std::size_t p = static_cast<std::size_t>(body) + 1; p < scene.parts.size(); ++p) {
    scene.parts[p].figure = figure;
  }
  give_part(scene.solids.spheres, spheres, body);
  give_part(scene.solids.round_cones, round_cones, body);
  give_part(scene.solids.meshes, meshes, body);
}

}  // namespace mien::scenes
