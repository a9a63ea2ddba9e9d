#include "scenes/sets.h"

#include <cmath>

#include "motion/error.h"
#include "motion/rotation.h"
#include "render/tone.h"

namespace mien::scenes {

namespace {

using motion::radians_per_degree;
using motion::Vec3;

/// The key light is far off and large: it lights a walk of ten metres alike and its shadows are as
/// soft at the far end as at the near one.
struct KeyLight {
  double azimuth = -28.0 * radians_per_degree;  // from the figure's front, negative to its left
  double elevation = 52.0 * radians_per_degree;
  double distance_m = 40.0;
  double side_m = 8.5;
  double floor_irradiance = 0.58 * motion::pi;  // a white floor would give back 0.58
};

render::AreaLight key_light(const KeyLight& key, const Vec3& centre, const Vec3& forward) {
  const Vec3 right = forward.cross(Vec3::UnitY());
  const Vec3 level = std::cos(key.azimuth) * forward + std::sin(key.azimuth) * right;
  const Vec3 towards = std::cos(key.elevation) * level + std::sin(key.elevation) * Vec3::UnitY();
  const Vec3 position = centre + key.distance_m * towards;
  // A small source seen face on from afar: irradiance = radiance · solid angle · cosine at the
  // floor.
  const double solid_angle = key.side_m * key.side_m / (key.distance_m * key.distance_m);
  const auto radiance =
      static_cast<float>(key.floor_irradiance / (solid_angle * std::sin(key.elevation)));
  const auto side = static_cast<float>(key.side_m);
  return render::softbox(position.cast<float>(), centre.cast<float>(), side, side,
                         render::Color(radiance, radiance, radiance));
}

render::Scene studio(const Vec3& centre, const Vec3& forward) {
  render::Scene scene;
  scene.lights.push_back(key_light({}, centre, forward));
  scene.sky.zenith = render::Color(0.46f, 0.47f, 0.48f);
  scene.sky.horizon = render::Color(0.36f, 0.365f, 0.37f);
  scene.sky.below = render::Color(0.26f, 0.26f, 0.255f);
  scene.sky.backdrop_horizon = render::linear_from_srgb8(210, 211, 211);
  scene.sky.backdrop_zenith = render::linear_from_srgb8(238, 241, 245);
  scene.ground.albedo = render::Color(0.70f, 0.70f, 0.69f);
  scene.ground.line_albedo = render::Color(0.52f, 0.53f, 0.54f);
  scene.ground.line_spacing = 0.5f;
  scene.ground.line_width = 0.010f;
  scene.ground.fade_start = 6.0f;
  scene.ground.fade_end = 30.0f;
  return scene;
}

}  // namespace

std::vector<std::string> set_names() { return {"studio"}; }

render::Scene make_set(std::string_view name, const Vec3& centre, const Vec3& forward) {
  if (name == "studio") return studio(centre, forward);
  throw Error("there is no scene \"" + std::string(name) + "\"", "choose studio");
}

}  // namespace mien::scenes
