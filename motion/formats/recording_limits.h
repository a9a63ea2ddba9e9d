#pragma once

#include <cstddef>

#include "motion/error.h"

namespace mien::motion {

/// Refuses, at `place`, a recording that is larger than any real one (65,536 joints; 2^27 joint
/// rotations, which take 4 GiB), so that a broken or hostile file cannot exhaust the memory.
void require_reasonable_size(const Place& place, size_t joints, size_t frames);

}  // namespace mien::motion
