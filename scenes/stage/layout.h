#pragma once

#include "scenes/cameras/camera_settings.h"

namespace mien::scenes {

/// The arrangement of several actors on one stage.
enum class Layout {
  superimposed,  ///< all begin at the same position, facing the same direction
  side_by_side,  ///< in a lane each
  as_recorded,   ///< where their motions are: people of one recording, or of one captured space
};

/// Whether the camera looks across the lanes of figures side by side, so that they occlude each
/// other.
bool looks_across_lanes(const CameraSettings& camera);

}  // namespace mien::scenes
