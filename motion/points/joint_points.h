#pragma once

#include "motion/points/point_recording.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// The joints of a motion as points, in its order and by its names (those that are empty or occur
/// again are changed, point_names.h); ends of bones are left out. The recording is in metres, which
/// `unit` does not repeat because few of its files state one.
///
/// A recording of points that could not be fitted to a body (a single joint with
/// `Recording::markers`) gives these points, with their gaps.
PointRecording joint_points(const Recording& recording);

}  // namespace mien::motion
