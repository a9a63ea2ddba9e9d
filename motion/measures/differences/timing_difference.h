#pragma once

#include <optional>

#include "motion/measures/distance/paired_motions.h"

namespace mien::motion {

/// How long a motion lasts.
struct MotionLength {
  int frames = 0;
  double frames_per_second = 0.0;
  double seconds = 0.0;  ///< Clip::duration_seconds
  bool loops = false;
};

/// The second motion is the first, delayed by some frames.
struct TimeShift {
  int frames = 0;  ///< at the first motion's rate; negative: earlier
  double seconds = 0.0;
  double explained = 0.0;  ///< share of the squared distances that it explains, 0.99 to 1
  bool path_too = true;    ///< false: only poses relative to the root are shifted
};

/// Frames were dropped or inserted at one point.
struct FrameGap {
  int frame = 0;           ///< of the first motion, the first that is missing or comes later
  int frames = 0;          ///< negative: frames dropped; positive: frames inserted
  double explained = 0.0;  ///< as of TimeShift
};

/// Timing of two motions. A shift or a gap is reported if it explains 99 % of the squared distances
/// between the points of all joints; at most one of these is reported.
struct TimingDifference {
  MotionLength before, now;
  std::optional<TimeShift> shift;
  std::optional<FrameGap> gap;
  bool other_pace = false;  ///< the same frames at another frame rate
  bool reversed = false;    ///< the same frames in reverse order
  int every = 1;            ///< k: every k-th frame at 1/k of the rate; −k: the reverse

  bool same_length() const {
    return before.frames == now.frames &&
           same_rate(before.frames_per_second, now.frames_per_second) && before.loops == now.loops;
  }
};

/// Shifts are sought up to half a second and a quarter of the shorter motion; gaps up to 3 frames
/// and what the second motion has more or fewer.
TimingDifference timing_difference(const Clip& before, const Clip& now, const PairedMotions& pair);

}  // namespace mien::motion
