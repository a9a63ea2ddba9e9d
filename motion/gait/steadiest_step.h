#pragma once

#include <optional>

#include "motion/gait/gait.h"

namespace mien::motion {

/// The cycle of a running take that consists of one step and the step's mirror image (`is_half`;
/// gait/loop.h), for takes that start or stop so soon that no two steps of theirs are alike. A step
/// may begin at any moment of the stride, not only at a heel strike. It lasts 0.2 to 0.7 s and has
/// a flight phase, however short (`foot_changes`). The end of a good step is like the mirror image
/// of its start, and it gains or loses little speed; of steps that are nearly as good as the best
/// the last is used, since runs that start approach their speed. `steadiness` is ½ where the speed
/// changes by a third over the step, or where the seam is ten times as visible as one that begins
/// to show. Empty if the take has no flight of 0.06 s, loops, or lasts more than 6 s (longer takes
/// contain whole cycles).
std::optional<GaitCycle> steadiest_step(const Clip& clip);

}  // namespace mien::motion
