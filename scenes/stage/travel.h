#pragma once

#include "motion/skeleton/clip.h"

namespace mien::scenes {

/// The way that a clip goes per frame on average, level, metres. Zero for one that goes slower than
/// 0.05 m/s or has a single frame.
motion::Vec3 mean_step(const motion::Clip& clip);

/// The clip with that way taken out: it walks on the spot where it began.
motion::Clip on_the_spot(motion::Clip clip, const motion::Vec3& step);

}  // namespace mien::scenes
