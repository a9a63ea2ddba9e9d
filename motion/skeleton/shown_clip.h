#pragma once

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// What a video shows, and a clip file holds: a loop repeated, or in place.
struct Showing {
  int cycles = 3;  ///< of a loop
  bool in_place = false;
};

Clip shown_clip(const Clip& clip, const Showing& showing);

}  // namespace mien::motion
