#pragma once

#include <array>
#include <optional>

#include <Eigen/Geometry>

#include "scenes/cameras/camera_rig.h"

namespace mien::scenes {

/// Where the figure stands in the picture: the point on the floor under the centre of the action,
/// or under the figure if the cameras follow it; pixels right of and below the picture's centre (of
/// a stereo pair: the mean of both). Nothing if it is behind the first camera.
std::optional<std::array<double, 2>> figure_place(const CameraRig& rig);

/// Bounding box of the action over all frames, pixels from the picture's centre as above, the
/// body's thickness included.
Eigen::AlignedBox2d action_bounds(const CameraRig& rig, const Action& action);

/// Shifts the pictures so that the figure, which is in front of the camera, stands there. The
/// perspective stays: the image plane moves, as with a shift lens.
void place_figure_at(CameraRig& rig, std::array<double, 2> place);

}  // namespace mien::scenes
