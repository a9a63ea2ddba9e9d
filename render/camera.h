#pragma once

#include <optional>

#include <Eigen/Core>

#include "render/vector.h"

namespace mien::render {

/// A pinhole camera with square pixels. Film x goes right and y goes down; pixel (i, j) covers
/// [i, i+1) × [j, j+1), its centre is at (i + ½, j + ½).
struct Camera {
  Vec3 position{0.0f, 1.0f, 5.0f};
  Vec3 target{0.0f, 1.0f, 0.0f};          ///< any point on the optical axis, not the position
  Vec3 up = Vec3::UnitY();                ///< not parallel to the axis
  float vertical_field_of_view = 0.524f;  ///< radians, 0 … π, from the top to the bottom edge
  int width = 960;                        ///< pixels
  int height = 540;                       ///< pixels
};

/// The camera's axes, computed once a picture: a film point (x, y) looks along
/// forward + (x − width/2)·step_right + (y − height/2)·step_down, before normalisation.
struct CameraFrame {
  Vec3 position;
  Vec3 forward;     ///< unit
  Vec3 step_right;  ///< change of direction per pixel
  Vec3 step_down;   ///< change of direction per pixel
  float half_width;
  float half_height;

  /// Unit direction through a film point.
  Vec3 direction(float x, float y) const {
    return (forward + (x - half_width) * step_right + (y - half_height) * step_down).normalized();
  }
};

/// Throws std::invalid_argument when the camera is degenerate (no size, target at the position, up
/// along the axis, field of view outside 0 … π).
CameraFrame frame_of(const Camera& camera);

/// Film coordinates, in pixels, of a point; nothing when it is not in front of the camera.
std::optional<Eigen::Vector2f> project(const Camera& camera, const Vec3& point);

}  // namespace mien::render
