#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "render/image/window.h"
#include "render/math/lanes.h"
#include "render/math/vector.h"

namespace mien::render {

/// A camera with square pixels. Image x goes right and y goes down; pixel (i, j) covers
/// [i, i+1) × [j, j+1), its centre is at (i + ½, j + ½).
struct Camera {
  Vec3 position{0.0f, 1.0f, 5.0f};
  Vec3 target{0.0f, 1.0f, 0.0f};          ///< any point on the optical axis in front of the camera
  Vec3 up = Vec3::UnitY();                ///< not parallel to the axis
  float vertical_field_of_view = 0.524f;  ///< radians, 0 … π, from the top to the bottom edge
  float parallel_height = 0.0f;  ///< metres from the top to the bottom edge of an orthographic
                                 ///< camera, which has no field of view; 0: perspective
  float shift_x = 0.0f;  ///< pixels; where the optical axis meets the image plane, right of the
                         ///< picture's centre
  float shift_y = 0.0f;  ///< pixels; below the picture's centre
  float aperture_radius = 0.0f;  ///< metres; 0: a pinhole, everything is sharp
  float focus_distance = 5.0f;   ///< along the axis, metres; needs an aperture
  int width = 960;               ///< pixels
  int height = 540;              ///< pixels
  std::optional<Window> window;  ///< the part to render, in pixels of the whole picture; none: all
};

/// Returns the part of the picture that is rendered.
Window window_of(const Camera& camera);

/// A ray from the camera into the scene. The direction has unit length.
struct CameraRay {
  Vec3 origin;
  Vec3 direction;
};

/// The camera's axes, computed once per picture.
struct CameraFrame {
  Vec3 position;
  Vec3 forward;     ///< unit
  Vec3 step_right;  ///< one pixel to the right, metres; perspective: at depth 1
  Vec3 step_down;   ///< one pixel down, metres; perspective: at depth 1
  float centre_x;   ///< pixels; where the optical axis meets the image plane
  float centre_y;
  bool parallel;
  Vec3 lens_right;  ///< from the centre of the aperture to its rim, metres; zero for a pinhole
  Vec3 lens_down;
  float focus_distance;

  /// Returns the ray through a point of the image plane (pixels) and the centre of the aperture.
  CameraRay ray(float x, float y) const {
    const CameraRay line = unnormalised_ray(x, y);
    return {line.origin, parallel ? line.direction : line.direction.normalized()};
  }

  /// As `ray`, but faster, because the direction is not normalised.
  CameraRay unnormalised_ray(float x, float y) const {
    const Vec3 aside = (x - centre_x) * step_right + (y - centre_y) * step_down;
    if (parallel) return {position + aside, forward};
    return {position, forward + aside};
  }

  /// Returns the ray through a point of the image plane (pixels) and a point of the aperture, whose
  /// centre is (0, 0) and whose rim has radius 1. Points at the focus distance are sharp.
  CameraRay ray(float x, float y, float lens_x, float lens_y) const;
};

/// Eight rays. Directions have unit length.
struct LaneRays {
  LaneVectors origin;
  LaneVectors direction;
};

/// Returns the rays through eight points of the image plane (pixels) and the centre of the
/// aperture.
LaneRays camera_rays(const CameraFrame& camera, const LaneFloats& x, const LaneFloats& y);

/// The points p with normal · p ≥ offset.
struct HalfSpace {
  Vec3 normal;  ///< unit
  float offset;
};

/// The view frustum, extended by `margin` pixels on each side: the intersection of four
/// half-spaces, as seen from the centre of the aperture.
std::array<HalfSpace, 4> view_of(const CameraFrame& frame, int width, int height, float margin);

/// Returns the camera's axes. Throws std::invalid_argument when the camera is degenerate (no size,
/// target at the position, up along the axis, field of view outside 0 … π, a window that is empty
/// or not within the picture, any other number outside its range).
CameraFrame frame_of(const Camera& camera);

/// Returns the image coordinates of a point, pixels; nothing when it is not in front of the camera.
std::optional<Eigen::Vector2f> project(const Camera& camera, const Vec3& point);

}  // namespace mien::render
