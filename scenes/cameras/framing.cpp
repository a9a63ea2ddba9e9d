#include "scenes/cameras/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mien::scenes {

namespace {

using motion::Vec3;

constexpr double filled_share = 0.88;  // of the picture, the rest is air
constexpr double infinity = std::numeric_limits<double>::infinity();

/// How far the points reach along a direction, both ways.
struct Reach {
  double least = infinity;
  double most = -infinity;

  void add(double low, double high) {
    least = std::min(least, low);
    most = std::max(most, high);
  }
  double middle() const { return 0.5 * (least + most); }
  double size() const { return most - least; }
};

render::Camera framing_in_parallel(const std::vector<Vec3>& points, double margin,
                                   const Vec3& towards, const Vec3& right, const Vec3& up,
                                   const Lens& lens) {
  Reach across, upwards, depth;
  for (const Vec3& point : points) {
    across.add(point.dot(right) - margin, point.dot(right) + margin);
    upwards.add(point.dot(up) - margin, point.dot(up) + margin);
    depth.add(point.dot(towards) - margin, point.dot(towards) + margin);
  }
  const double wide = across.size() * lens.size[1] / lens.size[0];
  const double height = std::max(upwards.size(), wide) / filled_share;
  const Vec3 target = across.middle() * right + upwards.middle() * up + depth.middle() * towards;
  const double far = std::max(0.5 * height / std::tan(0.5 * lens.fov_radians), depth.size());
  render::Camera camera = look_at_camera(target + far * towards, target, lens);
  camera.parallel_height = static_cast<float>(height);
  return camera;
}

}  // namespace

render::Camera look_at_camera(const Vec3& position, const Vec3& target, const Lens& lens) {
  render::Camera camera;
  camera.position = position.cast<float>();
  camera.target = target.cast<float>();
  camera.vertical_field_of_view = static_cast<float>(lens.fov_radians);
  camera.width = lens.size[0];
  camera.height = lens.size[1];
  if (lens.orthographic) {
    const double distance = (target - position).norm();
    camera.parallel_height = static_cast<float>(2.0 * distance * std::tan(0.5 * lens.fov_radians));
  }
  return camera;
}

render::Camera framing(const std::vector<Vec3>& points, double margin, const Vec3& towards,
                       const Lens& lens) {
  const Vec3 right = Vec3::UnitY().cross(towards).normalized();
  const Vec3 up = towards.cross(right);
  if (lens.orthographic) {
    return framing_in_parallel(points, margin, towards, right, up, lens);
  }
  const double tan_up = filled_share * std::tan(0.5 * lens.fov_radians);
  const double tan_right = tan_up * lens.size[0] / lens.size[1];
  double most_right = -infinity, most_left = -infinity, most_up = -infinity, most_down = -infinity;
  for (const Vec3& point : points) {
    const double x = point.dot(right);
    const double y = point.dot(up);
    const double z = point.dot(towards);
    const double reach_right = tan_right * z + margin * std::hypot(1.0, tan_right);
    const double reach_up = tan_up * z + margin * std::hypot(1.0, tan_up);
    most_right = std::max(most_right, x + reach_right);
    most_left = std::max(most_left, -x + reach_right);
    most_up = std::max(most_up, y + reach_up);
    most_down = std::max(most_down, -y + reach_up);
  }
  const double along = std::max((most_right + most_left) / (2.0 * tan_right),
                                (most_up + most_down) / (2.0 * tan_up));
  const Vec3 position =
      0.5 * (most_right - most_left) * right + 0.5 * (most_up - most_down) * up + along * towards;
  return look_at_camera(position, position - towards, lens);
}

}  // namespace mien::scenes
