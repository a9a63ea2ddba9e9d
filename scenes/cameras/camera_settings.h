#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/math/geometry.h"

namespace mien::scenes {

/// A key of a camera path. Points as in CameraSettings.
struct CameraKey {
  double seconds = 0.0;
  motion::Vec3 position = motion::Vec3::Zero();
  motion::Vec3 target = motion::Vec3::Zero();

  friend bool operator==(const CameraKey&, const CameraKey&) = default;
};

/// The display on which the video will be watched; the picture fills its width.
struct ScreenSettings {
  double distance_cm = 60.0;      ///< distance from the eye
  double width_cm = 52.0;         ///< width of the picture (of a stereo pair: of both)
  std::optional<double> degrees;  ///< visual angle of the standing figure; empty: it is life-size

  friend bool operator==(const ScreenSettings&, const ScreenSettings&) = default;
};

/// Depth of field: a lens that is in focus at one distance only.
struct DepthOfField {
  double aperture_m = 0.02;  ///< diameter of the aperture
  /// Focus distance along the optical axis; default: follows the figure.
  std::optional<double> focus_m;

  friend bool operator==(const DepthOfField&, const DepthOfField&) = default;
};

/// What the views frame.
enum class CameraSubject {
  whole_body,  ///< the whole body, and the floor under it
  upper_body,  ///< from the pelvis up, with the hands
  head,        ///< head and neck
};

/// The camera. Points are in metres from the centre of the action on the floor: x to the figure's
/// left, y up, z to its front.
struct CameraSettings {
  std::string view = "three-quarter";  ///< one of `camera_names`
  CameraSubject subject = CameraSubject::whole_body;
  bool orthographic = false;             ///< orthographic projection
  std::optional<double> fov_degrees;     ///< vertical field of view; default: 26; without effect if
                                         ///< there is a screen
  std::optional<motion::Vec3> position;  ///< replaces the view, together with `target`
  std::optional<motion::Vec3> target;
  std::vector<CameraKey> path;  ///< at least two keys, ascending in time; replaces the view
  /// Distance between the cameras of a stereo pair, whose pictures are side by side, the left eye's
  /// on the left; empty: one camera.
  std::optional<double> stereo_separation_m;
  std::optional<ScreenSettings> screen;
  std::optional<double> figure_px;             ///< height of the standing figure; sets the
                                               ///< distance, or the scale if orthographic
  std::optional<DepthOfField> depth_of_field;  ///< everything is sharp without it

  friend bool operator==(const CameraSettings&, const CameraSettings&) = default;
};

}  // namespace mien::scenes
