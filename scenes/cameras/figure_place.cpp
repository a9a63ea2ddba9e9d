#include "scenes/cameras/figure_place.h"

namespace mien::scenes {

namespace {

/// Image position of a point relative to the picture's centre; nothing when it is not in front of
/// the camera.
std::optional<Eigen::Vector2d> from_middle(const render::Camera& camera,
                                           const motion::Vec3& point) {
  const auto image_point = render::project(camera, point.cast<float>());
  if (!image_point) return std::nullopt;
  return image_point->cast<double>() - 0.5 * Eigen::Vector2d(camera.width, camera.height);
}

}  // namespace

std::optional<std::array<double, 2>> figure_place(const CameraRig& rig) {
  const auto place = from_middle(rig.cameras.front(), rig.figure_floor);
  if (!place) return std::nullopt;
  return std::array<double, 2>{place->x(), place->y()};
}

Eigen::AlignedBox2d action_bounds(const CameraRig& rig, const Action& action) {
  Eigen::AlignedBox2d part;
  for (std::size_t f = 0; f < action.points.size(); ++f) {
    for (const motion::Vec3& point : action.points[f]) {
      if (const auto seen = from_middle(rig.at(static_cast<int>(f)), point)) part.extend(*seen);
    }
  }
  const double margin_px = action.margin_m * figure_pixels(rig) / rig.figure_height_m;
  return {part.min().array() - margin_px, part.max().array() + margin_px};
}

void place_figure_at(CameraRig& rig, std::array<double, 2> place) {
  const auto [right, below] = figure_place(rig).value();
  for (render::Camera& camera : rig.cameras) {
    camera.shift_x += static_cast<float>(place[0] - right);
    camera.shift_y += static_cast<float>(place[1] - below);
  }
}

}  // namespace mien::scenes
