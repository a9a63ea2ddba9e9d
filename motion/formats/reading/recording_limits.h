#pragma once

#include <cstddef>

#include "motion/error.h"

namespace mien::motion {

/// Whether a recording has at most 65,536 joints and 2^27 joint rotations (4 GiB), so that a
/// corrupt or malicious file does not exhaust the memory.
bool is_reasonable_size(size_t joints, size_t frames);

/// Throws mien::Error at `place` if the size is not reasonable (`is_reasonable_size`).
void require_reasonable_size(const Place& place, size_t joints, size_t frames);

}  // namespace mien::motion
