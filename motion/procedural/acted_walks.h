#pragma once

#include "motion/procedural/walk_style.h"

namespace mien::motion {

// Further expressive walks, which the actors act alone: as in expressive_walks.h, what tells each
// from an ordinary walk is taken from studies of emotional gait, and how much is ours.

/// Fast, springy, with wide swings of bent arms that start abruptly, head up (Montepare et al. 1987
/// and Roether et al. 2009 on joy, further than happy_walk).
WalkStyle excited_walk();

/// Firm, broad and heavy: arms away from the trunk and turned inwards, chest out, feet apart, full
/// steps (Montepare et al. 1987 on pride and anger; the strong posture of the emotion thesis).
WalkStyle strong_walk();

/// Slow, short and low steps, arms close and hardly swinging, knees and trunk a little bent.
WalkStyle weak_walk();

}  // namespace mien::motion
