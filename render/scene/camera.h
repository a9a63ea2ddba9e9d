#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "render/image/window.h"
#include "render/math/vector.h"

namespace mien::render {

/// A camera with square pixels. Image x goes right and y goes down; pixel (i, j) covers
/// [i, i+1) × [j, j+1), its centre is at (i + ½, j + ½).
struct Camera {
  Vec3 position{0.0f, 1.0f, 5.0f};
  Vec3 target{0.0f, 1.0f, 0.0f};          ///< any point on the optical axis, not the position
  Vec3 up = Vec3::UnitY();                ///< not parallel to the axis
  float vertical_field_of_view = 0.524f;  ///< radians, 0 … π, from the top to the bottom edge
  float parallel_height = 0.0f;  ///< metres from the top to the bottom edge of an orthographic
                                 ///< camera, which has no field of view; 0: perspective
  float shift_x = 0.0f;  ///< pixels; where the optical axis meets the image plane, right of the
                         ///< picture's centre
  float shift_y = 0.0f;  ///< and below it
  float aperture_radius = 0.0f;  ///< metres; 0: a pinhole, everything is sharp
  float focus_distance = 5.0f;   ///< along the axis, metres; of a camera with an aperture
  int width = 960;               ///< pixels
  int height = 540;              ///< pixels
  std::optional<Window> window;  ///< the part that is rendered, bit for bit; none: all
};

/// The part of the picture that is rendered.
Window window_of(const Camera& camera);

/// A ray from the camera into the scene. The direction has unit length.
struct CameraRay {
  Vec3 origin;
  Vec3 direction;
};

/// The camera's axes, computed once a picture.
struct CameraFrame {
  Vec3 position;
  Vec3 forward;     ///< unit
  Vec3 step_right;  ///< a pixel to the right at distance 1 (perspective) or anywhere, metres
  Vec3 step_down;   ///< a pixel down; metres
  float centre_x;   ///< pixels; where the optical axis meets the image plane
  float centre_y;
  bool parallel;
  Vec3 lens_right;  ///< from the middle of the aperture to its rim; zero for a pinhole
  Vec3 lens_down;
  float focus_distance;

  /// The ray through a point of the image plane (pixels) and the centre of the aperture.
  CameraRay ray(float x, float y) const {
    const CameraRay line = unnormalised_ray(x, y);
    return {line.origin, parallel ? line.direction : line.direction.normalized()};
  }

  /// As `ray`, faster: the direction is not normalised.
  CameraRay unnormalised_ray(float x, float y) const {
    const Vec3 aside = (x - centre_x) * step_right + (y - centre_y) * step_down;
    if (parallel) return {position + aside, forward};
    return {position, forward + aside};
  }

  /// The ray through a point of the image plane (pixels) and a point of the aperture: (0, 0) is its
  /// centre, its rim has radius 1. Points at the focus distance stay in place.
  CameraRay ray(float x, float y, float lens_x, float lens_y) const;
};

/// The points p with normal · p ≥ offset.
struct HalfSpace {
  Vec3 normal;  ///< unit
  float offset;
};

/// The view frustum, extended by `margin` pixels on each side: the intersection of four
/// half-spaces, as seen from the centre of the aperture.
std::array<HalfSpace, 4> view_of(const CameraFrame& frame, int width, int height, float margin);

/// Throws std::invalid_argument when the camera is degenerate (no size, target at the position, up
/// along the axis, field of view outside 0 … π, a window that is not within the picture).
CameraFrame frame_of(const Camera& camera);

/// Image coordinates of a point, pixels; nothing when it is not in front of the camera.
std::optional<Eigen::Vector2f> project(const Camera& camera, const Vec3& point);

}  // namespace mien::render
