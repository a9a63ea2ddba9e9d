#pragma once

#include <array>
#include <string>
#include <vector>

#include "motion/clip.h"
#include "render/camera.h"
#include "render/scene.h"
#include "scenes/actor.h"
#include "scenes/camera_rig.h"
#include "scenes/figure.h"
#include "scenes/figure_colour.h"

namespace mien::scenes {

/// How a clip is shown. The set's name is one of `set_names`.
struct Look {
  std::string set = "studio";
  Figure figure;
  CameraSettings camera;
  Role role = Role::neutral;
  std::array<int, 2> size{960, 540};  ///< pixels
};

/// Clips staged: everything that is needed to draw any frame, in any order.
struct Shot {
  std::vector<Actor> actors;  ///< at least one
  render::Scene set;          ///< what stands still
  CameraRig cameras;

  /// Of the longest clip; an actor whose own has ended stands still.
  int frame_count() const;
};

/// Stages a clip that does not loop (`repeated` makes one of a loop). Throws Error for unknown
/// names.
Shot stage(const motion::Clip& clip, const Look& look);

render::Scene scene_at(const Shot& shot, int frame);
render::Camera camera_at(const Shot& shot, int frame);

}  // namespace mien::scenes
