#pragma once

#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// The clip played `tempo` times as fast at the same frame rate: directions and places between
/// frames by splines. A loop's duration is rounded to whole frames, at least 3; its way a cycle
/// stays.
Clip with_tempo(const Clip& clip, double tempo);

/// Plants of a clip of `frames_before` frames, when it has `frames_after` after a change of tempo.
std::vector<FootPlant> with_tempo(const std::vector<FootPlant>& plants, int frames_before,
                                  int frames_after, bool loops);

}  // namespace mien::motion
