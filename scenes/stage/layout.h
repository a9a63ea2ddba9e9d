#pragma once

#include "scenes/cameras/camera_settings.h"

namespace mien::scenes {

/// How clips of several actors stand on one stage.
enum class Layout { superimposed, side_by_side };

/// Whether figures side by side hide each other from a camera.
bool looks_along_lanes(const CameraSettings& camera);

}  // namespace mien::scenes
