#include "render/camera.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace mien::render {

CameraFrame frame_of(const Camera& camera) {
  if (camera.width < 1 || camera.height < 1)
    throw std::invalid_argument("camera: the picture has no pixels");
  const float angle = camera.vertical_field_of_view;
  if (!(angle > 0.0f && angle < std::numbers::pi_v<float>))
    throw std::invalid_argument("camera: the field of view is not between 0 and π");
  const Vec3 axis = camera.target - camera.position;
  const Vec3 right = axis.cross(camera.up);
  if (!(axis.norm() > 0.0f) || !(right.norm() > 1e-6f * axis.norm() * camera.up.norm()) ||
      !axis.allFinite() || !right.allFinite())
    throw std::invalid_argument("camera: position, target and up do not span a frame");

  CameraFrame frame;
  frame.position = camera.position;
  frame.forward = axis.normalized();
  const Vec3 unit_right = right.normalized();
  const auto half_height = static_cast<float>(camera.height) / 2.0f;
  const auto step = static_cast<float>(std::tan(0.5 * angle)) / half_height;
  frame.step_right = step * unit_right;
  frame.step_down = step * frame.forward.cross(unit_right);
  frame.half_width = static_cast<float>(camera.width) / 2.0f;
  frame.half_height = half_height;
  return frame;
}

std::optional<Eigen::Vector2f> project(const Camera& camera, const Vec3& point) {
  const CameraFrame frame = frame_of(camera);
  const Vec3 towards = point - frame.position;
  const float depth = towards.dot(frame.forward);
  if (!(depth > 0.0f)) return std::nullopt;
  const float scale = 1.0f / (depth * frame.step_right.squaredNorm());
  return Eigen::Vector2f{frame.half_width + towards.dot(frame.step_right) * scale,
                         frame.half_height + towards.dot(frame.step_down) * scale};
}

}  // namespace mien::render
