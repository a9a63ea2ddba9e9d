#pragma once

#include <filesystem>
#include <string>

#include "scenes/cameras/camera_settings.h"
#include "scenes/figures/figure.h"
#include "scenes/sets/set_plan.h"

namespace mien::pipeline {

/// What determines the colours of figures in a stimulus's film.
enum class Colours {
  neutral,  ///< one colour, that of all films: whoever watches cannot see a condition by it
  role      ///< that of the stimulus's role, as on sheets and overlays
};

/// How a clip becomes a picture.
struct Look {
  /// A set that comes with the program, or a file's path; empty: that of the figure's kind.
  std::string scene;
  std::filesystem::path scene_file;  ///< resolved; empty for a set that comes with the program
  std::string background;            ///< "#rrggbb" instead of the set's own; empty: its own
  scenes::Figure figure;
  scenes::CameraSettings camera;

  scenes::SetPlan set;  ///< what `scene` names, once it has been read (look_checks.h)

  Colours colours = Colours::neutral;  ///< of films of stimuli; overlays always go by roles
};

/// The name of the set, also where it was left open.
std::string scene_of(const Look& look);

/// What stands round the figure: the set with the background that look or point lights ask for.
scenes::SetPlan staged_set(const Look& look);

}  // namespace mien::pipeline
