#pragma once

#include "motion/skeleton/clip.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// The recording on its own joints, but in metres and with +Y up, as glTF requires: viewers would
/// show a figure in centimetres as a giant of 170 m. Unit and axes are determined as in
/// `analyse_rig`; recordings that are not human are unchanged.
Recording in_metres(Recording recording);

/// Converts `body` and its `poses` in place from a file's unit and axes to metres with +Y up:
/// lengths are multiplied by `metres_per_unit`, and everything is rotated by `to_y_up`, which takes
/// the file's up axis to +Y. The figure is not placed on the floor (see `clip_of`).
void to_metres(double metres_per_unit, const Quat& to_y_up, Skeleton& body,
               std::vector<Pose>& poses);

/// A recording as a clip, +Y up, on the floor: of the canonical body if the figure is human, else
/// of the recording's own skeleton with one unit taken as a metre, so that it can still be drawn.
Clip clip_of(const Recording& recording);

}  // namespace mien::motion
