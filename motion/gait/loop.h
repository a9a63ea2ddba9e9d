#pragma once

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Mismatch of the end of a cycle with its start: sum over the joints of squared distances between
/// direction vectors plus (0.1 s)² times that of their velocities. Heading and place do not count.
/// Frames lie in the clip.
double seam_cost(const Clip& clip, int start, int end);

struct CycleRange {
  int start = 0;
  int end = 0;
};

/// The start and end of least seam cost within `search` frames of the given ones.
CycleRange best_cut(const Clip& clip, CycleRange near, int search = 3);

/// Frames `start` to `end` of a clip as a loop. Frame `end` is the next cycle's first frame, so the
/// loop has end − start frames and its seam is no jump: the difference between the two is spread
/// over the cycle (rotations by their logarithms, the root's height and sideways position and its
/// heading), then the difference of velocities fades over 0.2 s on either side (after Holden's
/// looping demonstration). Of a motion that repeats exactly nothing is changed. The horizontal way
/// from `start` to `end` becomes `cycle_displacement`.
///
/// 0 ≤ start, end < frames, end − start ≥ 3 and the clip itself does not loop.
Clip closed_loop(const Clip& clip, int start, int end);

/// As `closed_loop`, keeping frame `end`: the pose of the first frame, one cycle displacement
/// further on.
Clip closed_ends(const Clip& clip, int start, int end);

/// One step, frames `start` to `end`, and its mirror image as a loop of 2·(end − start) frames, for
/// takes too short for two steps. The step is turned so that it walks along +Z and its end is made
/// to meet the mirror image of its start, in the way of `closed_loop`. Same conditions.
Clip mirrored_loop(const Clip& clip, int start, int end);

/// The loop shifted cyclically by `frames`: the same endless motion from another first frame, which
/// keeps its position in the first cycle.
Clip shifted_loop(const Clip& loop, int frames);

}  // namespace mien::motion
