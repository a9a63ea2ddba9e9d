#pragma once

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Bends the toes of one foot (`toe`: LeftToe or RightToe) up, by 70° at most, where their end
/// would be below the floor (y = 0), as at toe off in the many rigs with rigid toes.
void bend_toes_at_floor(Clip& clip, BodyJoint toe);

}  // namespace mien::motion
