#pragma once

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Bends the toes of one foot (`toe`: LeftToe or RightToe) up, by 70° at most, in frames in which
/// their end would be below the floor (y = 0), as at toe off in the many rigs with rigid toes. If
/// the ball of the foot is below the floor too, the end of the toes is raised only to the height of
/// the ball.
void bend_toes_at_floor(Clip& clip, BodyJoint toe);

}  // namespace mien::motion
