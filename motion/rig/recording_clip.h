#pragma once

#include "motion/skeleton/clip.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// The recording on its own joints, but in metres and with +Y up, as glTF has it: a figure in
/// centimetres would be a giant of 170 m to every viewer. Unit and axes are found as for drawing
/// (`sketch`); recordings that are not human are unchanged.
Recording in_metres(Recording recording);

/// Lengths in another unit and axes turned, before anything stands on a floor: for a body and its
/// poses whose file has `metres_per_unit` and whose up axis `to_y_up` takes to +Y.
void to_metres(double metres_per_unit, const Quat& to_y_up, Skeleton& body,
               std::vector<Pose>& poses);

/// A recording as a clip in metres, +Y up, on the floor: of the canonical body when the figure is
/// human, else of the recording's own skeleton, so that it can be drawn at all.
Clip clip_of(const Recording& recording);

}  // namespace mien::motion
