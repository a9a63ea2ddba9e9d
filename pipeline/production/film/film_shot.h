#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/clips/finished_motions.h"
#include "scenes/stage/shot.h"

namespace mien::pipeline {

/// The required framing of the figure, which overrides that of the camera.
struct Framing {
  std::optional<double> figure_px;                    ///< height of the standing figure in pixels
  std::optional<std::array<double, 2>> figure_place;  ///< scenes/cameras/figure_place.h
};

/// Returns the role that colours a stimulus's figure in its own film: neutral unless its look uses
/// the colours of roles.
Role film_role(const Stimulus& stimulus);

/// Returns how motions are staged for films with this look and output: everything but role, layout
/// and whether the figure walks in place. `seed` is that of the figure's random properties.
scenes::Look staged_look(const Look& look, const Output& output, std::uint64_t seed);

/// Returns the clip that the film of a stimulus with one motion shows on its set. Throws Error.
motion::Clip staged_clip(const Stimulus& stimulus, FinishedMotions& motions);

/// Returns the clips of a stimulus's people (people_clips) where they are on the stage. Throws
/// Error.
std::vector<motion::Clip> placed_people(const Stimulus& stimulus, FinishedMotions& motions);

/// Returns the horizontal direction from the stage to its front camera, unit, for clips of
/// placed_people: +Z or, if all people are where they were recorded, that from which the first
/// begins to the left of the second.
motion::Vec3 stage_front(const Stimulus& stimulus, const std::vector<motion::Clip>& people);

/// Returns a stimulus's motion, or its people, on its stage. `seed` is the production's seed.
/// Throws Error if the look is not available.
scenes::Shot shot_of(const Stimulus& stimulus, FinishedMotions& motions, std::uint64_t seed,
                     const Framing& framing = {});

/// Returns any clips of a stimulus's people on its stage, where they are.
scenes::Shot shot_of(const Stimulus& stimulus, std::vector<motion::Clip> people, std::uint64_t seed,
                     const Framing& framing);

/// Returns any clip on the stimulus's stage.
scenes::Shot shot_of(const Stimulus& stimulus, const motion::Clip& clip, std::uint64_t seed,
                     const Framing& framing);

/// Returns the motions of an overlay on its stage, with the overlay's own output settings (such as
/// frame rate and cycles) instead of those of its stimuli.
scenes::Shot shot_of(const Overlay& overlay, FinishedMotions& motions, std::uint64_t seed);

}  // namespace mien::pipeline
