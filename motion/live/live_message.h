#pragma once

#include <string>

#include "motion/live/live_core.h"
#include "motion/measures/distance/distance.h"

namespace mien::motion {

// Binary messages from the live core (live_core.h) to pages, sent by a server or by the module in
// the browser; little endian.

/// The message for a motion. u32: the characters "MOVE", number of frames, number of joints,
/// whether it loops, number of keytimes, number of weights. f64: frames per second, displacement
/// per cycle (3, metres), keytimes (seconds), weights, world positions (frames × joints × 3,
/// metres), world rotations (frames × joints × 4: x, y, z, w). u8: whether the left and the right
/// foot are planted (frames × 2).
std::string to_message(const LiveMotion& motion);

/// The message for a distance. u32: the characters "DIST", 0. f64: D, D_sum, distance by joint
/// (20), distance by time (11); metres.
std::string to_message(const Distance& distance);

}  // namespace mien::motion
