#include "scenes/point_light/dot_display.h"

#include <cmath>
#include <utility>

#include "motion/math/geometry.h"
#include "scenes/figures/figure_colour.h"

namespace mien::scenes {

namespace {

/// A regular polygon of so many corners has the area of its circle to 0.2 %.
constexpr int corners = 64;

/// Adds a polygon with the area of the circle of that radius.
void add_disc(render::Mesh& mesh, const render::Vec3& centre, float radius,
              const render::Vec3& right, const render::Vec3& down) {
  const auto first = static_cast<int>(mesh.positions.size());
  const render::Vec3 towards = down.cross(right).normalized();
  const double sector = 2.0 * motion::pi / corners;
  const auto rim = static_cast<float>(radius * std::sqrt(sector / std::sin(sector)));
  for (int k = 0; k < corners; ++k) {
    const auto x = static_cast<float>(std::cos(k * sector));
    const auto y = static_cast<float>(std::sin(k * sector));
    mesh.positions.push_back(centre + rim * (x * right + y * down));
    mesh.normals.push_back(towards);
    if (k >= 2) mesh.triangles.push_back({first, first + k - 1, first + k});
  }
}

}  // namespace

DotColours dot_colours(const PointLightOptions& options) {
  // Michelson 1927: contrast = (light − dark) / (light + dark).
  const auto dark = static_cast<float>((1.0 - options.contrast) / (1.0 + options.contrast));
  DotColours colours = {render::Color::Ones(), render::Color::Constant(dark)};
  if (options.dark_on_light) std::swap(colours.dots, colours.background);
  if (!options.colour.empty()) colours.dots = colour_from_hex(options.colour);
  if (!options.background.empty()) colours.background = colour_from_hex(options.background);
  return colours;
}

void add_dots(render::Scene& scene, const std::vector<Dot>& dots, int frame,
              const PointLightOptions& options, const render::Camera& camera) {
  const auto material = static_cast<int>(scene.materials.size());
  scene.materials.push_back(
      {.albedo = render::Color::Zero(), .emission = dot_colours(options).dots});
  const render::CameraFrame camera_frame = render::frame_of(camera);
  const float pixel = camera_frame.step_right.norm();
  const render::Vec3 right = camera_frame.step_right.normalized();
  const render::Vec3 down = camera_frame.step_down.normalized();
  render::Mesh discs;
  discs.material = material;
  for (const Dot& dot : dots) {
    if (!dot.is_shown(static_cast<std::size_t>(frame))) continue;
    const render::Vec3 centre = dot.path[static_cast<std::size_t>(frame)].cast<float>();
    if (options.size_m) {
      scene.solids.spheres.push_back({centre, static_cast<float>(0.5 * *options.size_m), material});
      continue;
    }
    const float depth = (centre - camera_frame.position).dot(camera_frame.forward);
    if (!camera_frame.parallel && depth <= 0.0f) continue;
    const float scale = camera_frame.parallel ? pixel : pixel * depth;
    add_disc(discs, centre, static_cast<float>(0.5 * options.size_px) * scale, right, down);
  }
  if (!discs.positions.empty()) scene.solids.meshes.push_back(std::move(discs));
}

}  // namespace mien::scenes
