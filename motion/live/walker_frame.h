#pragma once

#include <string>
#include <vector>

#include "motion/steered_walk/live_walk.h"

namespace mien::motion {

/// What a page is told of a walker before it walks, as JSON: {"set", "moods": […], "body":
/// {"names", "parents", "offsets", "tips"}}, metres; the body as LiveInfo of pages has it.
std::string walker_info(const LiveWalk& walk, const std::string& set);

/// A pose as pages show it: of each joint its place (x, y, z) in the world, metres, then of each
/// its rotation (x, y, z, w), joint frame → world, then whether the left and the right foot are
/// planted (1 or 0), then speed (m/s) and heading (°).
void write_frame(const LiveWalk& walk, const Pose& pose, std::vector<double>& frame);

}  // namespace mien::motion
