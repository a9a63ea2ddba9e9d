#pragma once

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Bends the toes (LeftToe, RightToe) up where their end would go through the floor, y = 0, as a
/// foot rolls off: those of a rig without a joint for them are stiff. By 70° at most; other poses
/// stay.
void bend_toes_at_floor(Clip& clip, BodyJoint toe);

}  // namespace mien::motion
