#include "scenes/cameras/stereo.h"

namespace mien::scenes {

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
