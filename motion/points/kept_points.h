#pragma once

#include <cstddef>
#include <vector>

#include "motion/points/point_recording.h"

namespace mien::motion {

/// Keeps some of the points, by index, in this order.
void keep_points(PointRecording& recording, const std::vector<std::size_t>& kept);

}  // namespace mien::motion
