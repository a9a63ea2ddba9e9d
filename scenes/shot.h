#pragma once

#include <array>
#include <string>

#include "motion/clip.h"
#include "render/camera.h"
#include "render/scene.h"
#include "scenes/camera_rig.h"
#include "scenes/figure_colour.h"

namespace mien::scenes {

/// How a clip is shown. Names are those of `set_names` and `camera_names`; the figure is "stick".
struct Look {
  std::string set = "studio";
  std::string figure = "stick";
  std::string camera = "three-quarter";
  Role role = Role::neutral;
  std::array<int, 2> size{960, 540};  ///< pixels
};

/// A clip staged: everything that is needed to draw any of its frames, in any order.
struct Shot {
  motion::Clip clip;  ///< at the video's frame rate; metres
  render::Scene set;  ///< what stands still
  CameraRig cameras;
  FigureColours colours;
  double height_m = 1.75;

  int frame_count() const { return clip.frame_count(); }
};

/// Names that `look: {figure: …}` takes.
std::vector<std::string> figure_names();

/// Stages a clip that does not loop (`repeated` makes one of a loop). Throws Error for unknown
/// names.
Shot stage(const motion::Clip& clip, const Look& look);

render::Scene scene_at(const Shot& shot, int frame);
render::Camera camera_at(const Shot& shot, int frame);

}  // namespace mien::scenes
