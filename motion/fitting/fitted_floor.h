#pragma once

#include "motion/fitting/body_tracks.h"
#include "motion/fitting/fit.h"

namespace mien::motion {

/// Bends the toes of feet whose tips are not known where they would be in the floor (toe_bend.h).
void bend_unknown_toes(const BodyTracks& tracks, Clip& clip);

/// Raises a fitted motion so that its feet stand on the floor, and turns feet without toes by the
/// floor (feet_without_points.h). The clip's floor is then at 0 as floor_height finds it once the
/// toes are bent, so that readers of the written skeleton leave the motion where it is. A motion
/// relative to the hips has the lower sole on the floor in each frame (hip_origin.h); ankles of
/// feet without toes first. Adds to `raised_by_frame`, which must have a value for each frame.
void put_on_floor(const BodyTracks& tracks, FittedMotion& fitted);

}  // namespace mien::motion
