#pragma once

#include <array>

#include "render/scene/camera.h"

namespace mien::scenes {

/// The left and the right eye of a camera: parallel axes, `separation_m` metres apart, and pictures
/// shifted (off-axis projection) so that points at the distance `convergence_m` have zero parallax.
std::array<render::Camera, 2> stereo_pair(const render::Camera& camera, double separation_m,
                                          double convergence_m);

}  // namespace mien::scenes
