#pragma once

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// What a video shows, and a clip file holds: a loop repeated, or in place.
struct Showing {
  int cycles = 3;  ///< of a loop
  bool in_place = false;
};

/// A loop is repeated; another clip is shown once. In place, both stay where they begin
/// (straighten.h).
Clip shown_clip(const Clip& clip, const Showing& showing);

}  // namespace mien::motion
