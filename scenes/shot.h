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
#include "scenes/set_plan.h"

namespace mien::scenes {

/// How a clip is shown.
struct Look {
  SetPlan set;
  Figure figure;
  CameraSettings camera;
  Role role = Role::neutral;
  std::array<int, 2> size{960, 540};  ///< pixels
};

/// Clips staged: everything that is needed to draw any frame, in any order.
struct Shot {
  std::vector<Actor> actors;  ///< at least one
  SetPlan set;
  Place place;                               ///< where the set stands
  render::Scene standing;                    ///< what stands still of it
  motion::Vec3 step = motion::Vec3::Zero();  ///< that a figure in place would go a frame, metres
  CameraRig cameras;

  /// Of the longest clip; an actor whose own has ended stands still.
  int frame_count() const;
};

/// Stages a clip that does not loop (`repeated` makes one of a loop). Throws Error when a figure or
/// camera cannot be had.
Shot stage(const motion::Clip& clip, const Look& look);

render::Scene scene_at(const Shot& shot, int frame);
render::Camera camera_at(const Shot& shot, int frame);

}  // namespace mien::scenes
