#pragma once

#include "scenes/cameras/camera_settings.h"

namespace mien::scenes {

/// The arrangement of several actors on one stage.
enum class Layout { superimposed, side_by_side };

/// Whether the camera looks along the lanes, so that figures side by side occlude each other.
bool looks_along_lanes(const CameraSettings& camera);

}  // namespace mien::scenes
