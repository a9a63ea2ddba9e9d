#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "motion/skeleton/clip.h"
#include "render/image/tone.h"
#include "render/scene/camera.h"
#include "render/scene/scene.h"
#include "scenes/cameras/camera_rig.h"
#include "scenes/figures/figure.h"
#include "scenes/figures/figure_colour.h"
#include "scenes/sets/set_plan.h"
#include "scenes/stage/actor.h"
#include "scenes/stage/layout.h"

namespace mien::scenes {

/// The way that a clip goes per frame on average, level, metres. Zero for one that goes slower than
/// 0.05 m/s or has a single frame.
motion::Vec3 mean_step(const motion::Clip& clip);

/// The clip with that way taken out: it walks on the spot where it began.
motion::Clip on_the_spot(motion::Clip clip, const motion::Vec3& step);

/// How clips are shown.
struct Look {
  SetPlan set;
  Figure figure;
  CameraSettings camera;
  Role role = Role::neutral;
  std::array<int, 2> size{960, 540};     ///< pixels that the camera frames
  std::optional<render::Window> window;  ///< the part of them that is drawn; not of a stereo pair
  double pixel_scale = 1.0;              ///< sizes in pixels become so many times as large
  std::optional<std::array<double, 2>> figure_place;  ///< where the figure stands in the picture
  bool in_place = false;                              ///< on the spot, whatever the set
  Layout layout = Layout::superimposed;
  std::uint64_t seed = 0;  ///< of what is random about a figure
};

/// A clip, and what it stands for.
struct Performance {
  std::string name = "figure";
  motion::Clip clip;  ///< at the video's frame rate; does not loop
  Role role = Role::neutral;
  float opacity = 1.0f;
};

/// Clips staged: everything that is needed to draw any frame, in any order.
struct Shot {
  std::vector<Actor> actors;  ///< at least one
  SetPlan set;
  Place place;                               ///< where the set stands
  render::Scene static_scene;                ///< what stands still of it
  motion::Vec3 step = motion::Vec3::Zero();  ///< that a figure in place would go a frame, metres
  CameraRig cameras;
  Action action;                      ///< what the cameras have in the picture
  std::array<int, 2> size{960, 540};  ///< pixels of a whole picture

  /// Of the tone curve: point lights have exactly the colours that were asked for.
  render::Tone tone;

  /// Of the longest clip; an actor whose own has ended stands still.
  int frame_count() const;
};

/// Stages a clip that does not loop (`repeated` makes one of a loop). One that begins farther than
/// 100 m from the origin is moved there, where single precision is fine enough. Throws Error when a
/// figure or camera cannot be had.
Shot stage(const motion::Clip& clip, const Look& look);

/// Stages several clips together, by `layout` and with the roles that they have. Superimposed ones
/// begin in the same place, facing the same way; those side by side have a lane each, the first at
/// the left of the picture as the front sees it. The set and the cameras go by all of them. Throws
/// Error also for figures side by side before a camera at their side, and for point lights.
Shot stage(const std::vector<Performance>& performances, const Look& look);

/// What is seen at a frame, and from where. A stereo pair has two cameras, the left eye's first,
/// each for half of the picture.
render::Scene scene_at(const Shot& shot, int frame);

/// Likewise, made of the very solids of the scene at frame `made_at`, a frame nearby: what moves
/// in between does so solid by solid.
render::Scene scene_at(const Shot& shot, int frame, int made_at);
std::vector<render::Camera> cameras_at(const Shot& shot, int frame);

/// The middle of the eyes.
const render::Camera& camera_at(const Shot& shot, int frame);

}  // namespace mien::scenes
