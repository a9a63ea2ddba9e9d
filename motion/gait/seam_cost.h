#pragma once

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// How badly `end` of a cycle meets its `start`: sum over the joints of squared distances between
/// direction vectors plus (0.1 s)² times that of their velocities. Heading and place do not count.
/// Frames lie in the clip.
double seam_cost(const Clip& clip, int start, int end);

struct CyclePlace {
  int start = 0;
  int end = 0;
};

/// The start and end of least seam cost within `search` frames of the given ones.
CyclePlace best_cut(const Clip& clip, CyclePlace near, int search = 3);

}  // namespace mien::motion
