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
#include "scenes/figures/shown_hands.h"
#include "scenes/sets/set_plan.h"
#include "scenes/stage/actor.h"
#include "scenes/stage/layout.h"

namespace mien::scenes {

/// Mean horizontal displacement of a clip per frame, metres. Zero if the clip is slower than 0.05
/// m/s or has a single frame.
motion::Vec3 mean_step(const motion::Clip& clip);

/// The clip with the displacement `step`, metres per frame, removed: the figure walks in place at
/// its first position.
motion::Clip on_the_spot(const motion::Clip& clip, const motion::Vec3& step);

/// How clips are shown.
struct Look {
  SetPlan set;
  Figure figure;
  Hands hands = Hands::automatic;
  CameraSettings camera;
  Role role = Role::neutral;
  std::array<int, 2> size{960, 540};     ///< size of the picture that the camera frames, pixels
  std::optional<render::Window> window;  ///< the part that is rendered; not with stereo
  double pixel_scale = 1.0;              ///< factor applied to sizes that are given in pixels
  /// Position of the figure, pixels right of and below the picture's centre (figure_place.h).
  std::optional<std::array<double, 2>> figure_place;
  bool in_place = false;  ///< whether the figure walks in place, regardless of the set
  MeshDetail detail = MeshDetail::full;
  Layout layout = Layout::superimposed;
  std::uint64_t seed = 0;  ///< for the random properties of a figure
  /// Horizontal direction from the stage to the front camera, unit; by default that of the first
  /// clip.
  std::optional<motion::Vec3> forward;
};

/// A clip and its role.
struct Performance {
  std::string name = "figure";
  motion::Clip clip;  ///< at the video's frame rate; does not loop
  Role role = Role::neutral;
  float opacity = 1.0f;
  std::optional<FigureColours> colours;  ///< instead of those of the role
  std::optional<Figure> figure;          ///< instead of the look's; dots only if it has dots too
  std::optional<Hands> hands;            ///< instead of the look's
};

/// The clip, with its markers, turned about the vertical and moved so that it begins at `place` on
/// the floor and goes or faces (Action::forward) `turn_radians` to the left of +Z.
motion::Clip placed(const motion::Clip& clip, const motion::Vec3& place, double turn_radians);

/// The clip, with its markers, moved by `shift`, metres.
motion::Clip shifted(const motion::Clip& clip, const motion::Vec3& shift);

/// Staged clips: everything needed to render any frame, in any order.
struct Shot {
  std::vector<Actor> actors;  ///< at least one
  SetPlan set;
  Place place;                 ///< placement of the set
  render::Scene static_scene;  ///< the static part of the set
  /// Travel per frame that was removed from the first actor, metres; for a point-light figure,
  /// that of the dots as displayed (changed_step).
  motion::Vec3 step = motion::Vec3::Zero();
  CameraRig cameras;
  Action action;                      ///< motion that the cameras frame
  std::array<int, 2> size{960, 540};  ///< pixels of a whole picture

  /// Tone curve of the shot; point-light displays have exactly the requested colours.
  render::Tone tone;

  /// Frames of the longest clip; actors stand still after the end of theirs.
  int frame_count() const;
};

/// Stages a clip that does not loop (`repeated` converts a loop). A clip that begins farther than
/// 100 m from the origin is moved to the origin, where single precision suffices. Actors whose
/// relaxed hands are not from their motion (shown_hands.h) have a warning. Throws Error when a
/// figure or camera cannot be made.
Shot stage(const motion::Clip& clip, const Look& look);

/// Stages several clips together, by `layout` and with their roles. Superimposed clips begin at the
/// same position, facing the same direction. Clips side by side have a lane each, the first on the
/// left in the front view. Clips as recorded keep their places, headings and frames; they may be
/// shown as dots. The set and the cameras are fitted to all clips. Also throws Error for other
/// figures of a kind that overlays cannot show (FigureKind), and for figures side by side if the
/// camera looks across their lanes (layout.h).
Shot stage(const std::vector<Performance>& performances, const Look& look);

/// The scene at a frame.
render::Scene scene_at(const Shot& shot, int frame);

/// The scene at a frame, with the same list of solids as at the nearby frame `made_at`, so that
/// motion blur can pair them.
render::Scene scene_at(const Shot& shot, int frame, int made_at);

/// The cameras at a frame: one, or those of the left and the right eye of a stereo pair, each for
/// one half of the picture.
std::vector<render::Camera> cameras_at(const Shot& shot, int frame);

/// The camera at a frame; of a stereo pair the one between the eyes.
const render::Camera& camera_at(const Shot& shot, int frame);

}  // namespace mien::scenes
