#pragma once

#include <cstddef>

#include "motion/error.h"

namespace mien::motion {

/// Whether a recording may be real: it has no more than 65,536 joints, and no more than 2^27 joint
/// rotations, which take 4 GiB. A broken or hostile file could exhaust the memory otherwise.
bool is_reasonable_size(size_t joints, size_t frames);

/// Refuses, at `place`, one that has more.
void require_reasonable_size(const Place& place, size_t joints, size_t frames);

}  // namespace mien::motion
