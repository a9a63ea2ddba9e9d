#pragma once

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Bends the toes (LeftToe, RightToe) up where their end would go through the floor, y = 0, as a
/// foot rolls off: those of many rigs are stiff. By 70° at most; where they stay above they are
/// left alone.
void bend_toes_at_floor(Clip& clip, BodyJoint toe);

}  // namespace mien::motion
