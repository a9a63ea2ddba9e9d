#pragma once

#include "motion/skeleton/clip.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// The recording on its own joints, but in metres and with +Y up, as glTF has it: a figure in
/// centimetres would be a giant of 170 m to every viewer. Unit and axes are found as for drawing
/// (`sketch`); recordings that are not human are unchanged.
Recording in_metres(Recording recording);

/// Converts `body` and its `poses` in place from a file's unit and axes to metres with +Y up:
/// lengths are multiplied by `metres_per_unit`, and everything is rotated by `to_y_up`, which takes
/// the file's up axis to +Y. The figure is not moved onto the floor; clip_of does that afterwards.
void to_metres(double metres_per_unit, const Quat& to_y_up, Skeleton& body,
               std::vector<Pose>& poses);

/// A recording as a clip in metres, +Y up, on the floor: of the canonical body when the figure is
/// human, else of the recording's own skeleton, so that it can be drawn at all.
Clip clip_of(const Recording& recording);

}  // namespace mien::motion
