#pragma once

#include <string>

#include "motion/live/live_core.h"
#include "motion/measures/distance/distance.h"

namespace mien::motion {

// Binary messages from the motion core to pages, from a server or from the module in the browser;
// little endian.

/// u32 "MOVE", frames, joints, loops, keytimes, weights; then f64: frames a second, displacement
/// (3), keytimes, weights, world positions (frames × joints × 3, metres), world rotations (frames ×
/// joints × 4: x, y, z, w); then u8: whether the left and the right foot stand (frames × 2).
std::string to_message(const LiveMotion& motion);

/// u32 "DIST", 0; then f64: D, D_sum, by joint (20), by time (11). Metres.
std::string to_message(const Distance& distance);

}  // namespace mien::motion
