#pragma once

#include <optional>

#include "render/math/vector.h"
#include "render/scene/camera.h"

namespace mien::render {

/// Returns the distance, in multiples of the direction's length, at which a ray hits the floor from
/// above; nothing if it does not.
inline std::optional<float> distance_to_floor(const Vec3& origin, const Vec3& direction) {
  if (!(origin.y() > 0.0f && direction.y() < 0.0f)) return std::nullopt;
  return -origin.y() / direction.y();
}

/// A point of the floor, metres.
struct FloorPlace {
  float x;
  float z;
};

/// The points of the floor seen at the centres of a row of pixels; they lie on a straight line. The
/// pixel u columns to the right of the optical axis shows the point (x, z) + s · (from + u · step),
/// where from + u · step is the offset at depth 1 along the optical axis and s = height / (drop + u
/// · drop_step). For an orthographic camera from + u · step is the point itself: x and z are 0, s
/// is 1.
struct FloorRow {
  float x = 0.0f;  ///< below the camera, metres; 0 for an orthographic camera
  float z = 0.0f;
  float from_x = 0.0f;  ///< offset from (x, z) at depth 1 and u = 0
  float from_z = 0.0f;
  float step_x = 0.0f;  ///< change of this offset per pixel to the right
  float step_z = 0.0f;
  float height = 1.0f;     ///< of the camera above the floor, metres; 1 for an orthographic one
  float drop = 1.0f;       ///< descent of the ray at u = 0 per unit of depth
  float drop_step = 0.0f;  ///< change of `drop` per pixel to the right
  float centre = 0.0f;     ///< image x of the optical axis

  FloorRow() = default;
  FloorRow(const CameraFrame& camera, int y) : centre(camera.centre_x) {
    const Vec3 down = (static_cast<float>(y) + 0.5f - camera.centre_y) * camera.step_down;
    const Vec3& right = camera.step_right;
    if (!camera.parallel) {
      const Vec3 towards = camera.forward + down;
      x = camera.position.x();
      z = camera.position.z();
      from_x = towards.x();
      from_z = towards.z();
      step_x = right.x();
      step_z = right.z();
      height = camera.position.y();
      drop = -towards.y();
      drop_step = -right.y();
      return;
    }
    // All rays are parallel; a camera that looks up or along the floor does not show it.
    const Vec3& forward = camera.forward;
    const float lean_x = forward.y() < 0.0f ? forward.x() / forward.y() : 0.0f;
    const float lean_z = forward.y() < 0.0f ? forward.z() / forward.y() : 0.0f;
    const Vec3 from = camera.position + down;
    from_x = from.x() - from.y() * lean_x;
    from_z = from.z() - from.y() * lean_z;
    step_x = right.x() - right.y() * lean_x;
    step_z = right.z() - right.y() * lean_z;
  }

  /// Returns the point of the floor at the centre of the pixel in this column; meaningless where
  /// the pixel does not show the floor.
  FloorPlace at(int column) const {
    const float u = static_cast<float>(column) + 0.5f - centre;
    const float s = height / (drop + u * drop_step);
    return {x + s * (from_x + u * step_x), z + s * (from_z + u * step_z)};
  }

  /// Returns whether the floor points are monotonic in x and in z along the row despite rounding.
  /// If the horizon is tilted, rounding may swap two neighbours.
  bool is_in_order() const { return drop_step == 0.0f; }
};

}  // namespace mien::render
