#pragma once

#include "motion/animate/animation_report.h"

namespace mien::motion {

/// What becomes of a motion at its ends.
struct MotionEnds {
  bool loops = false;        ///< the motion goes on from its beginning; excludes the others
  double hold_before = 0.0;  ///< seconds for which the first pose stays
  double hold_after = 0.0;   ///< seconds for which the last pose stays

  bool is_empty() const { return !loops && hold_before == 0.0 && hold_after == 0.0; }

  friend bool operator==(const MotionEnds&, const MotionEnds&) = default;
};

/// The motion with these ends. Poses are held for whole frames, the nearest number to the time
/// asked for, but one at least. A motion that goes on from its beginning becomes a loop
/// (gait/loop.h, closed_loop): the difference between its last and first pose is distributed over
/// the whole motion, which thereby is one frame shorter, and the way from its first to its last
/// place is covered anew in each cycle. The remarks say how large that difference was.
///
/// Throws mien::Error for a skeleton other than the canonical body, for a motion that is to be held
/// but loops, and for one of fewer than four frames that is to loop. A motion that loops already is
/// returned as it is.
AnimatedClip with_ends(const Clip& clip, const MotionEnds& ends);

/// Frames by which everything is later in the result.
int frames_before(const MotionEnds& ends, double frames_per_second);

}  // namespace mien::motion
