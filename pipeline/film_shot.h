#pragma once

#include <cstdint>

#include "pipeline/manifest.h"
#include "pipeline/motions.h"
#include "scenes/shot.h"

namespace mien::pipeline {

/// A stimulus's motion on its stage. `seed` is that of the production. Throws Error when the look
/// cannot be had.
scenes::Shot shot_of(const Stimulus& stimulus, Motions& motions, std::uint64_t seed);

}  // namespace mien::pipeline
