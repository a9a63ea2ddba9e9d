#pragma once

#include "motion/live/live_bundle.h"

namespace mien::motion {

/// Whether motions can be made of what was read: what the code that makes them takes for granted
/// holds.
bool is_usable(const LiveBundle& bundle);

}  // namespace mien::motion
