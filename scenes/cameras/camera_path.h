#pragma once

#include <array>
#include <vector>

#include "render/scene/camera.h"
#include "scenes/cameras/camera_settings.h"

namespace mien::scenes {

/// The position and target of a camera path at a time in seconds: a cubic Hermite spline through
/// the keys (Catmull & Rom 1974, tangents for uneven times), constant before the first and after
/// the last. The keys must ascend in time; at least one is required.
CameraKey camera_on_path(const std::vector<CameraKey>& path, double seconds);

/// The left and the right eye of a camera: parallel axes, `separation_m` metres apart, and pictures
/// shifted (off-axis projection) so that points at the distance `convergence_m` have zero parallax.
std::array<render::Camera, 2> stereo_pair(const render::Camera& camera, double separation_m,
                                          double convergence_m);

}  // namespace mien::scenes
