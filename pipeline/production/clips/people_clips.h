#pragma once

#include <vector>

#include "motion/skeleton/clip.h"
#include "pipeline/manifest/stimulus.h"
#include "pipeline/production/clips/finished_motions.h"

namespace mien::pipeline {

/// Returns the number of frames of a stimulus's film before durations are equalized. With several
/// people it lasts as long as the person who ends last, with loops repeated `output.cycles` times.
/// Throws Error if the motion of one of them has ended before the film begins.
int own_frames(const Stimulus& stimulus, FinishedMotions& motions);

/// Returns the clips of a stimulus's people, in their order and where their motions are. Each has
/// as many frames as the film: a motion that begins later is preceded by its first pose, one that
/// loops is repeated, and any other stays in its last pose. Throws Error.
std::vector<motion::Clip> people_clips(const Stimulus& stimulus, FinishedMotions& motions);

}  // namespace mien::pipeline
