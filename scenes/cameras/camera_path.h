#pragma once

#include <vector>

#include "scenes/cameras/camera_settings.h"

namespace mien::scenes {

/// The position and target of a camera path at a time: a cubic Hermite spline through the keys
/// (Catmull & Rom 1974, tangents for uneven times), constant before the first and after the last.
/// The keys ascend in time; there is at least one.
CameraKey camera_on_path(const std::vector<CameraKey>& path, double seconds);

}  // namespace mien::scenes
