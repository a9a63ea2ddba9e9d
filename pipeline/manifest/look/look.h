#pragma once

#include <filesystem>
#include <string>

#include "scenes/cameras/camera_settings.h"
#include "scenes/figures/face.h"
#include "scenes/figures/figure.h"
#include "scenes/figures/shown_hands.h"
#include "scenes/sets/set_plan.h"

namespace mien::pipeline {

/// How the colours of figures in a stimulus's film are chosen.
enum class Colours {
  neutral,  ///< the same colour in all films, so that it does not reveal the condition
  role      ///< colour of the stimulus's role, as on sheets and overlays
};

/// How a clip is staged and shown.
struct Look {
  /// A built-in set or the path of a file; empty: the default set of the figure's kind.
  std::string scene;
  std::filesystem::path scene_file;  ///< resolved; empty for a built-in set
  std::string background;            ///< "#rrggbb"; empty: the set's own background
  scenes::Figure figure;
  scenes::Face face;                               ///< of a character
  scenes::Hands hands = scenes::Hands::automatic;  ///< of figures of all kinds
  scenes::CameraSettings camera;

  scenes::SetPlan set;  ///< the set named scene_of(look), once it has been read by resolve_set

  /// For films of stimuli; overlays always use the colours of roles.
  Colours colours = Colours::neutral;
};

/// Returns the name of the look's set or, if the look names none, of the default set of its
/// figure's kind.
std::string scene_of(const Look& look);

/// Returns the figure with its face.
scenes::Figure shown_figure(const Look& look);

/// Returns the set of the shot, with the background that the look states or that a point-light
/// figure (dots) requires.
scenes::SetPlan staged_set(const Look& look);

}  // namespace mien::pipeline
