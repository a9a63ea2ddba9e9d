#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "motion/clip.h"
#include "render/camera.h"
#include "scenes/camera_settings.h"

namespace mien::scenes {

/// Names that `look: {camera: …}` takes: front, side, three-quarter, follow, orbit.
std::vector<std::string> camera_names();

/// One camera a frame of a clip.
struct CameraRig {
  std::vector<render::Camera> cameras;  ///< a single one for a standing camera

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
};

/// Forward is the way the figure travels when it travels further than half a metre, and otherwise
/// the mean of where its pelvis faces (+Z for a skeleton that is not the body).
Action action_of(const motion::Clip& clip);

/// Places the camera so that the whole action is in the picture, with the same air on all sides as
/// far as the picture's shape allows.
///
/// `front` looks the figure in the face, `side` sees it walk from left to right, `three-quarter`
/// stands between them; `follow` is the three-quarter camera going with the figure, `orbit` circles
/// once round the action. Throws Error for an unknown name.
CameraRig make_camera_rig(const CameraSettings& settings, const Action& action,
                          std::array<int, 2> size);

}  // namespace mien::scenes
