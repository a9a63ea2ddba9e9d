#pragma once

#include <array>
#include <string>
#include <vector>

#include "motion/skeleton/clip.h"
#include "render/scene/camera.h"
#include "scenes/cameras/camera_settings.h"

namespace mien::scenes {

/// Names that `look: {camera: …}` takes: front, side, three-quarter, follow, orbit.
std::vector<std::string> camera_names();

/// One camera a frame of a clip.
struct CameraRig {
  std::vector<render::Camera> cameras;  ///< a single one for a standing camera
  double stereo_separation_m = 0.0;     ///< 0: one picture; else a left and a right one
  double convergence_m = 5.0;           ///< at this distance both show the same place alike
  double figure_height_m = 1.75;        ///< of the standing figure

  /// Where the figure stands when the first camera looks: in the middle of its way, or where it is
  /// then if the cameras go with it; metres.
  motion::Vec3 figure_floor = motion::Vec3::Zero();

  /// How far before the cameras the middle of the figure is, along their axes: of those that go
  /// with it at all times, of others when it is in the middle of its way. 0 or less: behind.
  double figure_distance_m = 5.0;

  const render::Camera& at(int frame) const {
    return cameras.size() == 1 ? cameras.front() : cameras[static_cast<size_t>(frame)];
  }
};

/// What has to be in the picture: joint positions frame by frame, and where the figure faces.
struct Action {
  std::vector<std::vector<motion::Vec3>> points;  ///< world space, metres; frame by frame
  motion::Vec3 forward = motion::Vec3::UnitZ();   ///< unit, horizontal
  motion::Vec3 centre = motion::Vec3::Zero();     ///< of all that happens, on the floor
  double margin_m = 0.1;                          ///< flesh round the points
  double height_m = 1.75;                         ///< of the standing figure
  double frames_per_second = 30.0;
};

/// Forward is the way the figure travels when it travels further than half a metre, and otherwise
/// the mean of where its pelvis faces (+Z for a skeleton that is not the body).
Action action_of(const motion::Clip& clip);

/// Places the camera so that the whole action is in the picture, with the same air on all sides as
/// far as the picture's shape allows.
///
/// `front` looks the figure in the face, `side` sees it walk from left to right, `three-quarter`
/// stands between them; `follow` is the three-quarter camera going with the figure, `orbit` circles
/// once round the action. Position and target, or a path, take the view's place; a screen decides
/// angle of view and distance instead of what has to be in the picture. Cameras of a stereo pair
/// are half as wide. Throws Error for an unknown view.
CameraRig make_camera_rig(const CameraSettings& settings, const Action& action,
                          std::array<int, 2> size);

/// How tall the standing figure is in the picture, pixels, and under which visual angle an eye sees
/// it that sees the picture as the camera does, degrees. 0 where it is behind.
double figure_pixels(const CameraRig& rig);
double visual_degrees(const CameraRig& rig);

/// How far from the eye a figure of that height has to be to be seen on the screen as asked.
double eye_distance_m(const ScreenSettings& screen, double height_m);

}  // namespace mien::scenes
