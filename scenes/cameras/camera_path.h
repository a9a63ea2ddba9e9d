#pragma once

#include <vector>

#include "scenes/cameras/camera_settings.h"

namespace mien::scenes {

/// Where a camera on a path is at a moment: through the keys, smoothly (cubic Hermite with the
/// tangents of Catmull & Rom 1974 for uneven times), at rest before the first and after the last.
/// The keys ascend in time; there is at least one.
CameraKey camera_on_path(const std::vector<CameraKey>& path, double seconds);

}  // namespace mien::scenes
