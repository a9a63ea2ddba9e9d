#pragma once

#include <span>
#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/modify/modification.h"

namespace mien::motion {

/// The weighted mean of poses of the same body: rotations by their direction vectors, made
/// orthonormal again (what they lack comes from `previous`), root places by sums. Weights sum to 1.
Pose mean_pose(std::span<const Pose* const> poses, std::span<const double> weights,
               const Pose& previous);

/// The weighted mean of clips of the same body, frames and rate: rotations by their direction
/// vectors, made orthonormal again; root places and ways a cycle by sums. Weights sum to 1. A clip
/// whose weight is 1 comes out as it is.
Clip mean_clip(std::span<const Clip> clips, std::span<const double> weights);

/// The motion at the modification's position (paths, acceleration) on the grid of the thesis, the
/// nine motions {short, as is, long} × {constant speed, as is, accelerated}. `original` travels.
/// Paths are changed first, then the feet carried along, then the timing of each is changed, and
/// the (at most four) motions around the place are mixed bilinearly. Explicit gains take the place
/// of the paths' mix.
Clip grid_motion(const Clip& original, const std::vector<FootPlant>& plants,
                 const Modification& modification);

}  // namespace mien::motion
