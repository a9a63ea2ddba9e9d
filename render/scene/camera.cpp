#include "render/scene/camera.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "render/math/for_avx2.h"

namespace mien::render {
namespace {

bool lies_within(const Window& window, int width, int height) {
  return window.x >= 0 && window.y >= 0 && window.width >= 1 && window.height >= 1 &&
         window.x <= width - window.width && window.y <= height - window.height;
}

}  // namespace

Window window_of(const Camera& camera) {
  return camera.window.value_or(Window{0, 0, camera.width, camera.height});
}

CameraFrame frame_of(const Camera& camera) {
  if (camera.width < 1 || camera.height < 1)
    throw std::invalid_argument("camera: the picture has no pixels");
  const float angle = camera.vertical_field_of_view;
  if (camera.parallel_height == 0.0f && !(angle > 0.0f && angle < std::numbers::pi_v<float>))
    throw std::invalid_argument("camera: the field of view is not between 0 and π");
  if (!(camera.parallel_height >= 0.0f && std::isfinite(camera.parallel_height)))
    throw std::invalid_argument("camera: the height of its view is negative or not finite");
  if (!std::isfinite(camera.shift_x) || !std::isfinite(camera.shift_y))
    throw std::invalid_argument("camera: its shift is not finite");
  if (!(camera.aperture_radius >= 0.0f && std::isfinite(camera.aperture_radius)) ||
      !(camera.focus_distance > 0.0f))
    throw std::invalid_argument("camera: aperture or focus distance is not positive");
  if (camera.window && !lies_within(*camera.window, camera.width, camera.height))
    throw std::invalid_argument("camera: the window is empty or not within the film");
  const Vec3 axis = camera.target - camera.position;
  const Vec3 right = axis.cross(camera.up);
  if (!(axis.norm() > 0.0f) || !(right.norm() > 1e-6f * axis.norm() * camera.up.norm()) ||
      !axis.allFinite() || !right.allFinite())
    throw std::invalid_argument("camera: position, target and up do not span a frame");

  CameraFrame frame;
  frame.position = camera.position;
  frame.forward = axis.normalized();
  const Vec3 unit_right = right.normalized();
  const Vec3 unit_down = frame.forward.cross(unit_right);
  const auto height = static_cast<float>(camera.height);
  frame.parallel = camera.parallel_height > 0.0f;
  const float step = frame.parallel ? camera.parallel_height / height
                                    : static_cast<float>(std::tan(0.5 * angle)) / (0.5f * height);
  frame.step_right = step * unit_right;
  frame.step_down = step * unit_down;
  frame.centre_x = static_cast<float>(camera.width) / 2.0f + camera.shift_x;
  frame.centre_y = height / 2.0f + camera.shift_y;
  frame.lens_right = camera.aperture_radius * unit_right;
  frame.lens_down = camera.aperture_radius * unit_down;
  frame.focus_distance = camera.focus_distance;
  return frame;
}

std::array<HalfSpace, 4> view_of(const CameraFrame& frame, int width, int height, float margin) {
  const float left = -margin, top = -margin;
  const float right = static_cast<float>(width) + margin;
  const float bottom = static_cast<float>(height) + margin;
  // Each side contains the rays through both ends of an edge of the film, in this order round it.
  const float corners[5][2] = {
      {left, top}, {right, top}, {right, bottom}, {left, bottom}, {left, top}};
  std::array<HalfSpace, 4> view;
  for (std::size_t i = 0; i < 4; ++i) {
    const CameraRay from = frame.ray(corners[i][0], corners[i][1]);
    const CameraRay to = frame.ray(corners[i + 1][0], corners[i + 1][1]);
    const Vec3 along = frame.parallel ? Vec3(to.origin - from.origin) : to.direction;
    const Vec3 normal = from.direction.cross(along).normalized();
    view[i] = {normal, normal.dot(from.origin)};
  }
  return view;
}

CameraRay CameraFrame::ray(float x, float y, float lens_x, float lens_y) const {
  const CameraRay sharp = ray(x, y);
  const Vec3 focus =
      sharp.origin + (focus_distance / sharp.direction.dot(forward)) * sharp.direction;
  const Vec3 origin = sharp.origin + lens_x * lens_right + lens_y * lens_down;
  return {origin, (focus - origin).normalized()};
}

MIEN_FOR_AVX2_TOO LaneRays camera_rays(const CameraFrame& camera, const LaneFloats& x,
                                       const LaneFloats& y) {
  LaneRays rays;
  const bool parallel = camera.parallel;
  // Whether directions or origins differ between the rays.
  const float all = parallel ? 0.0f : 1.0f, some = parallel ? 1.0f : 0.0f;
  const float px = camera.position.x(), py = camera.position.y(), pz = camera.position.z();
  const float fx = camera.forward.x(), fy = camera.forward.y(), fz = camera.forward.z();
  const float rx = camera.step_right.x(), ry = camera.step_right.y(), rz = camera.step_right.z();
  const float sx = camera.step_down.x(), sy = camera.step_down.y(), sz = camera.step_down.z();
  const float centre_x = camera.centre_x, centre_y = camera.centre_y;
#pragma omp simd
  for (unsigned i = 0; i < lanes; ++i) {
    const float u = x.lane[i] - centre_x, v = y.lane[i] - centre_y;
    const float ax = u * rx + v * sx, ay = u * ry + v * sy, az = u * rz + v * sz;
    const float dx = fx + all * ax, dy = fy + all * ay, dz = fz + all * az;
    const float scale = 1.0f / std::sqrt(dx * dx + dy * dy + dz * dz);
    rays.origin.x.lane[i] = px + some * ax;
    rays.origin.y.lane[i] = py + some * ay;
    rays.origin.z.lane[i] = pz + some * az;
    rays.direction.x.lane[i] = dx * scale;
    rays.direction.y.lane[i] = dy * scale;
    rays.direction.z.lane[i] = dz * scale;
  }
  return rays;
}

std::optional<Eigen::Vector2f> project(const Camera& camera, const Vec3& point) {
  const CameraFrame frame = frame_of(camera);
  const Vec3 towards = point - frame.position;
  const float depth = towards.dot(frame.forward);
  if (!(depth > 0.0f)) return std::nullopt;
  const float scale = 1.0f / ((frame.parallel ? 1.0f : depth) * frame.step_right.squaredNorm());
  return Eigen::Vector2f{frame.centre_x + towards.dot(frame.step_right) * scale,
                         frame.centre_y + towards.dot(frame.step_down) * scale};
}

}  // namespace mien::render
