#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "render/image/window.h"
#include "render/math/vector.h"

namespace mien::render {

/// A camera with square pixels. Film x goes right and y goes down; pixel (i, j) covers
/// [i, i+1) × [j, j+1), its centre is at (i + ½, j + ½).
struct Camera {
  Vec3 position{0.0f, 1.0f, 5.0f};
  Vec3 target{0.0f, 1.0f, 0.0f};          ///< any point on the optical axis, not the position
  Vec3 up = Vec3::UnitY();                ///< not parallel to the axis
  float vertical_field_of_view = 0.524f;  ///< radians, 0 … π, from the top to the bottom edge
  float parallel_height = 0.0f;  ///< metres from the top to the bottom edge of an orthographic
                                 ///< camera, which has no field of view; 0: perspective
  float shift_x = 0.0f;  ///< the optical axis meets the film so many pixels right of its middle
  float shift_y = 0.0f;  ///< and so many below
  float aperture_radius = 0.0f;  ///< metres; 0: a pinhole, everything is sharp
  float focus_distance = 5.0f;   ///< along the axis, metres; of a camera with an aperture
  int width = 960;               ///< pixels
  int height = 540;              ///< pixels
  std::optional<Window> window;  ///< the part of the film that is drawn, alone and to the bit as
                                 ///< it would be in the whole; none: all
};

/// The part of the camera's film that is drawn.
Window window_of(const Camera& camera);

/// A ray of light, seen from the eye. The direction has unit length.
struct EyeRay {
  Vec3 origin;
  Vec3 direction;
};

/// The camera's axes, computed once a picture.
struct CameraFrame {
  Vec3 position;
  Vec3 forward;     ///< unit
  Vec3 step_right;  ///< a pixel to the right at distance 1 (perspective) or anywhere, metres
  Vec3 step_down;   ///< a pixel down, likewise
  float centre_x;   ///< film point that the axis goes through
  float centre_y;
  bool parallel;
  Vec3 lens_right;  ///< from the middle of the aperture to its rim; zero for a pinhole
  Vec3 lens_down;
  float focus_distance;

  /// Through a film point and the middle of the aperture.
  EyeRay ray(float x, float y) const {
    const EyeRay line = line_through(x, y);
    return {line.origin, parallel ? line.direction : line.direction.normalized()};
  }

  /// The same, quicker: the direction has any length.
  EyeRay line_through(float x, float y) const {
    const Vec3 aside = (x - centre_x) * step_right + (y - centre_y) * step_down;
    if (parallel) return {position + aside, forward};
    return {position, forward + aside};
  }

  /// Through a film point and a point of the aperture, (0, 0) in its middle, its rim at radius 1.
  /// What lies at the focus distance stays where `ray` sees it.
  EyeRay ray(float x, float y, float lens_x, float lens_y) const;
};

/// The points p with normal · p ≥ offset.
struct HalfSpace {
  Vec3 normal;  ///< unit
  float offset;
};

/// What a camera sees, `margin` pixels beyond its film on each side: the points in all four. Of a
/// camera with an aperture it is what the middle of that sees.
std::array<HalfSpace, 4> view_of(const CameraFrame& frame, int width, int height, float margin);

/// Throws std::invalid_argument when the camera is degenerate (no size, target at the position, up
/// along the axis, field of view outside 0 … π, a window that is not within the film).
CameraFrame frame_of(const Camera& camera);

/// Film coordinates, in pixels, of a point; nothing when it is not in front of the camera.
std::optional<Eigen::Vector2f> project(const Camera& camera, const Vec3& point);

}  // namespace mien::render
