#pragma once

#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Height of the floor under a clip: the level on which the lower foot stands, measured at the ball
/// of the foot while it rests (median height while it is slow). Toes that dip at toe off are
/// ignored, as are rests more than 0.08 m (at a stature of 1.75 m) above the lowest (steps, raised
/// feet). If neither ball rests, the result is the third percentile of the height of the lowest
/// sole point in the frames in which that point is slow (in all frames if it hardly ever is).
/// Metres.
double floor_height(const Clip& clip);

/// The rotation that levels a sloping floor, which occurs in captures with a misaligned capture
/// volume. Identity unless the feet rest on one slope of 0.3–6°, with at least four plants and a
/// spread of at least 0.4 m (standard deviation), and the slope removes a large part of an RMS
/// error that would exceed a centimetre on a level floor.
Quat floor_levelling(const Clip& clip);

}  // namespace mien::motion
