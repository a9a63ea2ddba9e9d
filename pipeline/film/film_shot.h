#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/synthesis/motions.h"
#include "scenes/stage/shot.h"

namespace mien::pipeline {

/// A stimulus's motion on its stage. `seed` is that of the production. With `figure_px` the figure
/// is so tall in the picture, whatever its camera says. Throws Error when the look cannot be had.
scenes::Shot shot_of(const Stimulus& stimulus, Motions& motions, std::uint64_t seed,
                     std::optional<double> figure_px = std::nullopt);

/// The motions of an overlay on their stage, each as long as the overlay's own output says.
scenes::Shot shot_of(const Overlay& overlay, Motions& motions, std::uint64_t seed);

}  // namespace mien::pipeline
