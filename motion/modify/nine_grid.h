#pragma once

#include <span>
#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/gestures/hand_hits.h"
#include "motion/modify/modification.h"

namespace mien::motion {

/// The weighted mean of poses of one body. Rotations are averaged as direction vectors and made
/// orthonormal again (`previous` supplies the direction where the mean is degenerate); root
/// positions are averaged linearly. Weights sum to 1.
Pose mean_pose(std::span<const Pose* const> poses, std::span<const double> weights,
               const Pose& previous);

/// The weighted mean, frame by frame, of clips with the same body, number of frames and frame rate,
/// as in `mean_pose`. Cycle displacements are averaged too. Weights sum to 1. A single clip is
/// returned unchanged.
Clip mean_clip(std::span<const Clip> clips, std::span<const double> weights);

/// The motion at the modification's position (paths, acceleration) on the grid of the emotion
/// thesis, the nine motions {short, as is, long} × {constant speed, as is, accelerated}. `original`
/// must not walk in place. Path lengths are changed first, then the hips are shifted, then the
/// limbs are retimed, and the (at most four) neighbouring grid motions are interpolated bilinearly.
/// If the modification has explicit path gains, they are used instead of interpolating path
/// lengths. If acceleration applies at contacts, hands with `hits` are retimed around these
/// (hit_timing.h).
Clip grid_motion(const Clip& original, const std::vector<FootPlant>& plants,
                 const Modification& modification, const std::vector<HandHit>& hits = {});

}  // namespace mien::motion
