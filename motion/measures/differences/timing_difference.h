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

/// The second motion does what the first does, some frames later.
struct TimeShift {
  int frames = 0;  ///< of the first motion's rate; negative: earlier
  double seconds = 0.0;
  double explained = 0.0;  ///< share of the squared distances that is gone after it, 0.99 to 1
  bool path_too = true;    ///< otherwise only poses are shifted: places are told from the root's
};

/// From some frame on the second motion is some frames earlier or later than before it.
struct FrameGap {
  int frame = 0;           ///< of the first motion, the first that is missing or comes later
  int frames = 0;          ///< negative: so many were left out; positive: so many came in
  double explained = 0.0;  ///< as of TimeShift
};

/// When things happen in two motions. A shift or a gap is told when it explains nearly all (99 %)
/// of the squared distances between the points of all joints; at most one of all these is told.
struct TimingDifference {
  MotionLength before, now;
  std::optional<TimeShift> shift;
  std::optional<FrameGap> gap;
  bool other_pace = false;  ///< the same frames in order, played at another rate
  bool reversed = false;    ///< the same frames, the last first
  int every = 1;  ///< k: every k-th frame alone at a k-th of the rate; −k: the other way round

  bool same_length() const {
    return before.frames == now.frames &&
           same_rate(before.frames_per_second, now.frames_per_second) && before.loops == now.loops;
  }
};

/// Shifts are sought up to half a second and a quarter of the shorter motion; gaps up to 3 frames
/// and what the second motion has more or fewer.
TimingDifference timing_difference(const Clip& before, const Clip& now, const PairedMotions& pair);

}  // namespace mien::motion
