#include "scenes/cameras/camera_path.h"

#include <algorithm>

namespace mien::scenes {

namespace {

using motion::Vec3;
using Point = Vec3 CameraKey::*;

/// Metres per second at a key.
Vec3 tangent(const std::vector<CameraKey>& path, std::size_t key, Point point) {
  const CameraKey& before = path[key == 0 ? 0 : key - 1];
  const CameraKey& after = path[std::min(key + 1, path.size() - 1)];
  return (after.*point - before.*point) / (after.seconds - before.seconds);
}

Vec3 between(const std::vector<CameraKey>& path, std::size_t key, double seconds, Point point) {
  const CameraKey& from = path[key];
  const CameraKey& to = path[key + 1];
  const double span = to.seconds - from.seconds;
  const double t = (seconds - from.seconds) / span;
  const double s = 1.0 - t;
  return (1.0 + 2.0 * t) * s * s * (from.*point) + t * t * (3.0 - 2.0 * t) * (to.*point) +
         t * s * span * (s * tangent(path, key, point) - t * tangent(path, key + 1, point));
}

}  // namespace

CameraKey camera_on_path(const std::vector<CameraKey>& path, double seconds) {
  if (seconds <= path.front().seconds) return path.front();
  if (seconds >= path.back().seconds) return path.back();
  std::size_t key = 0;
  while (path[key + 1].seconds <= seconds) ++key;
  return {seconds, between(path, key, seconds, &CameraKey::position),
          between(path, key, seconds, &CameraKey::target)};
}

std::array<render::Camera, 2> stereo_pair(const render::Camera& camera, double separation_m,
                                          double convergence_m) {
  const render::CameraFrame frame = render::frame_of(camera);
  const render::Vec3 right = frame.step_right.normalized();
  const auto metres_a_pixel = static_cast<double>(frame.step_right.norm()) * convergence_m;
  std::array<render::Camera, 2> eyes = {camera, camera};
  for (int side = 0; side < 2; ++side) {
    const double aside = (side - 0.5) * separation_m;
    render::Camera& eye = eyes[static_cast<std::size_t>(side)];
    eye.position += static_cast<float>(aside) * right;
    eye.target += static_cast<float>(aside) * right;
    eye.shift_x += static_cast<float>(aside / metres_a_pixel);
  }
  return eyes;
}

}  // namespace mien::scenes
