#pragma once

#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// The clip played `tempo` times as fast at the same frame rate; rotations (as direction vectors)
/// and root positions are interpolated by splines. The duration is rounded to whole frames (of a
/// loop, at least 3). The cycle displacement is unchanged.
Clip with_tempo(const Clip& clip, double tempo);

/// Frames after a change of tempo per frame before it.
double frame_scale(int frames_before, int frames_after, bool loops);

/// The plants of a clip after a change of tempo that took it from `frames_before` to `frames_after`
/// frames.
std::vector<FootPlant> with_tempo(const std::vector<FootPlant>& plants, int frames_before,
                                  int frames_after, bool loops);

}  // namespace mien::motion
