#pragma once

#include <array>
#include <string>
#include <vector>

#include "motion/skeleton/clip.h"
#include "render/scene/camera.h"
#include "scenes/cameras/camera_settings.h"

namespace mien::scenes {

/// Names that `look: {camera: …}` accepts: front, side, three-quarter, follow, orbit.
std::vector<std::string> camera_names();

/// The cameras for the frames of a clip.
struct CameraRig {
  std::vector<render::Camera> cameras;  ///< one per frame; a single one if it never changes
  double stereo_separation_m = 0.0;     ///< 0: no stereo; else a left and a right picture
  double convergence_m = 5.0;           ///< distance of zero parallax
  double figure_height_m = 1.75;        ///< height of the standing figure

  /// Floor position of the figure for the first camera: the centre of the action or, if the cameras
  /// follow the figure, its position in the first frame; world space, metres.
  motion::Vec3 figure_floor = motion::Vec3::Zero();

  /// Distance, along the first camera's axis, of the middle of a figure that stands at
  /// `figure_floor`. 0 or less: behind the camera.
  double figure_distance_m = 5.0;

  const render::Camera& at(int frame) const {
    return cameras.size() == 1 ? cameras.front() : cameras[static_cast<size_t>(frame)];
  }
};

/// The motion that the camera frames: positions of joints and tips in all frames, and the figure's
/// facing direction.
struct Action {
  std::vector<std::vector<motion::Vec3>> points;  ///< world space, metres; frame by frame
  /// The part of the body that views frame, in the same frames; empty: `points`, and the floor
  /// under them.
  std::vector<std::vector<motion::Vec3>> framed = {};
  motion::Vec3 forward = motion::Vec3::UnitZ();  ///< unit, horizontal
  motion::Vec3 centre = motion::Vec3::Zero();  ///< centre of the whole action, on the floor, metres
  double margin_m = 0.1;                       ///< thickness of the body around the points
  double height_m = 1.75;                      ///< height of the standing figure
  double frames_per_second = 30.0;
};

/// The action of a clip. Forward is the direction of travel if the figure travels farther than half
/// a metre, otherwise the mean facing direction of the pelvis (+Z for a skeleton other than the
/// canonical body).
Action action_of(const motion::Clip& clip);

/// World positions of the joints and tips of a part of the body, frame by frame; empty for the
/// whole body, and for a skeleton other than the canonical body.
std::vector<std::vector<motion::Vec3>> subject_points(const motion::Clip& clip,
                                                      CameraSubject subject);

/// Places the camera so that the whole action is in the picture, with equal margins on all sides as
/// far as the aspect ratio allows.
///
/// `front` faces the figure, `side` sees it walk from left to right, `three-quarter` is between
/// them; `follow` is the three-quarter camera following the figure, `orbit` circles once around the
/// action. Position and target, or a path, replace the view; a screen in the settings determines
/// the field of view and, if the view is not replaced, the distance, in place of the framing. The
/// pictures of a stereo pair are half as wide as `size`. Throws Error for an unknown view.
CameraRig make_camera_rig(const CameraSettings& settings, const Action& action,
                          std::array<int, 2> size);

/// Height of the standing figure in the first camera's picture, pixels, and its visual angle for an
/// observer at the camera's position, degrees. 0 if it is behind the camera (the height in an
/// orthographic picture is the same at any distance).
double figure_pixels(const CameraRig& rig);
double visual_degrees(const CameraRig& rig);

/// Distance from the camera, metres, at which a figure of this height has the requested visual
/// angle or, if none is requested, is life-size on the screen.
double eye_distance_m(const ScreenSettings& screen, double height_m);

}  // namespace mien::scenes
