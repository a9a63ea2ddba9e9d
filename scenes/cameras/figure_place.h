#pragma once

#include <array>
#include <optional>

#include <Eigen/Geometry>

#include "scenes/cameras/camera_rig.h"

namespace mien::scenes {

/// The figure's position in the picture: the point on the floor below the centre of the action, or
/// below the figure if the cameras follow it; pixels right of and below the picture's centre (of a
/// stereo pair: the mean of the positions in both pictures). Nothing if it is behind the first
/// camera.
std::optional<std::array<double, 2>> figure_place(const CameraRig& rig);

/// Bounding box of the action over all frames, including the body's thickness, in pixels from the
/// picture's centre as above.
Eigen::AlignedBox2d action_bounds(const CameraRig& rig, const Action& action);

/// Shifts the pictures so that the figure, which must be in front of the camera, is at this
/// position (in the coordinates of figure_place). The perspective is unchanged: only the image
/// plane moves, as with a shift lens.
void place_figure_at(CameraRig& rig, std::array<double, 2> place);

}  // namespace mien::scenes
