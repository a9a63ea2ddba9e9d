#pragma once

#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Height of the floor under a clip: the level on which the lower foot stands, where its ball rests
/// (the median of its height while it is slow). Toes that dip at toe off do not count, nor rests
/// higher than 0.08 m above the lowest (steps, raised feet). If no ball rests it is the third
/// percentile of the lowest sole point.
double floor_height(const Clip& clip);

/// The rotation that levels a floor which slopes in the recording, as happens when the capture
/// volume was not levelled: identity unless the feet rest along one slope of 0.3–6°, over at least
/// 0.8 m and four separate plants, and a level floor would leave errors of more than a centimetre
/// (RMS) that the slope takes away for the most part.
Quat floor_levelling(const Clip& clip);

}  // namespace mien::motion
