#pragma once

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Mismatch between the end and the start of a cycle: the sum over joints of the squared distances
/// between their direction vectors, plus (0.1 s)² times the squared distances between the
/// velocities of these vectors. Heading and root position are ignored. Both frames must lie in the
/// clip.
double seam_cost(const Clip& clip, int start, int end);

/// The mismatch between frame `end` of one clip and frame `start` of another on the same body.
double seam_cost(const Clip& starting, int start, const Clip& ending, int end);

struct CycleRange {
  int start = 0;
  int end = 0;
};

/// The start and end frames with the lowest seam cost within `search` frames of the given ones.
CycleRange best_cut(const Clip& clip, CycleRange near, int search = 3);

/// Frames `start` to `end` of a clip as a loop. Frame `end` is the first frame of the next cycle,
/// so the loop has end − start frames. The seam is smoothed: the difference between the two frames
/// is distributed over the cycle (rotations, including the heading, by their logarithms, and the
/// height of the root), then the difference between the velocities fades over 0.2 s on either side
/// (after Holden's looping demonstration). A motion that repeats exactly is unchanged, provided
/// that the clip has a frame before `start` or after `end`. The horizontal displacement from
/// `start` to `end` becomes `cycle_displacement`.
///
/// Both frames must lie in the clip, `end` at least 3 after `start`, and the clip must not loop.
Clip closed_loop(const Clip& clip, int start, int end);

/// As `closed_loop`, but the result does not loop. It includes frame `end`, which has the pose of
/// the first frame, displaced by one cycle displacement.
Clip closed_ends(const Clip& clip, int start, int end);

/// One step, frames `start` to `end`, and its mirror image as a loop of 2·(end − start) frames, for
/// takes too short for two steps. The step is rotated to walk along +Z, and its end is adjusted to
/// match the mirror image of its start. The conditions of `closed_loop` apply.
Clip mirrored_loop(const Clip& clip, int start, int end);

/// The loop shifted cyclically: the same periodic motion, beginning at frame `frames` of `loop`.
/// World positions do not change: the new first frame stands where frame `frames` does (one cycle
/// displacement farther for each cycle by which `frames` exceeds the loop).
Clip shifted_loop(const Clip& loop, int frames);

}  // namespace mien::motion
