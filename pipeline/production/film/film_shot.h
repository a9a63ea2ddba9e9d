#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/clips/finished_motions.h"
#include "scenes/stage/shot.h"

namespace mien::pipeline {

/// How the figure has to be in the picture, whatever its camera says.
struct Framing {
  std::optional<double> figure_px;                    ///< height of the standing figure
  std::optional<std::array<double, 2>> figure_place;  ///< scenes/cameras/figure_place.h
};

/// What a stimulus's figure stands for in its own film: nothing, unless its look asks for roles.
Role film_role(const Stimulus& stimulus);

/// The clip that a stimulus's film shows on its set. Throws Error.
motion::Clip staged_clip(const Stimulus& stimulus, FinishedMotions& motions);

/// A stimulus's motion on its stage. `seed` is that of the production. Throws Error when the look
/// cannot be had.
scenes::Shot shot_of(const Stimulus& stimulus, FinishedMotions& motions, std::uint64_t seed,
                     const Framing& framing = {});

/// Any clip on the stimulus's stage.
scenes::Shot shot_of(const Stimulus& stimulus, const motion::Clip& clip, std::uint64_t seed,
                     const Framing& framing);

/// The motions of an overlay on their stage, each as long as the overlay's own output says.
scenes::Shot shot_of(const Overlay& overlay, FinishedMotions& motions, std::uint64_t seed);

}  // namespace mien::pipeline
