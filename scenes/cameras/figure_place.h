#pragma once

#include <array>
#include <optional>

#include <Eigen/Geometry>

#include "scenes/cameras/camera_rig.h"

namespace mien::scenes {

/// Where the figure stands in the picture: the point on the floor under the middle of what it does,
/// or under the figure itself where the cameras go with it; pixels right of and below the picture's
/// middle (of a stereo pair: of each eye's picture between the two). Nothing where the first camera
/// has it behind itself.
std::optional<std::array<double, 2>> figure_place(const CameraRig& rig);

/// The part of the picture that the action takes at any time, flesh and all, pixels from the
/// picture's middle as above.
Eigen::AlignedBox2d taken_part(const CameraRig& rig, const Action& action);

/// Shifts the pictures until the figure, which is before the camera, stands there. Nothing is seen
/// from elsewhere: the middle of the film moves, as with a shift lens.
void stand_at(CameraRig& rig, std::array<double, 2> place);

}  // namespace mien::scenes
