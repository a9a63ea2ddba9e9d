#pragma once

#include "motion/skeleton/clip.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// A recording as a clip in metres, +Y up, on the floor: of the canonical body when the figure is
/// human, else of the recording's own skeleton, so that it can be drawn at all.
Clip clip_of(const Recording& recording);

}  // namespace mien::motion
