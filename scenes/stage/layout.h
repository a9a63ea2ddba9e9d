#pragma once

#include "scenes/cameras/camera_settings.h"

namespace mien::scenes {

/// The arrangement of several actors on one stage.
enum class Layout { superimposed, side_by_side };

/// Whether the camera looks across the lanes of figures side by side, so that they occlude each
/// other.
bool looks_across_lanes(const CameraSettings& camera);

}  // namespace mien::scenes
