#pragma once

#include <optional>

#include "motion/measures/distance/paired_motions.h"

namespace mien::motion {

/// The length of a motion.
struct MotionLength {
  int frames = 0;
  double frames_per_second = 0.0;
  double seconds = 0.0;  ///< Clip::duration_seconds
  bool loops = false;
};

/// A delay of the second motion relative to the first.
struct TimeShift {
  int frames = 0;  ///< at the first motion's frame rate; negative: earlier
  double seconds = 0.0;
  double explained = 0.0;  ///< explained share of the squared distances, 0.99 to 1
  bool path_too = true;  ///< whether the root's path is delayed too, not only poses relative to it
};

/// Frames were dropped or inserted at one point.
struct FrameGap {
  int frame = 0;   ///< first frame of the first motion that is missing or delayed in the second
  int frames = 0;  ///< negative: frames dropped; positive: frames inserted
  double explained = 0.0;  ///< as in TimeShift
};

/// Timing of two motions. A shift or a gap is reported if it explains at least 99 % of the squared
/// distances between the points of all joints; at most one of shift, gap, `other_pace`, `reversed`
/// and `every` is reported.
struct TimingDifference {
  MotionLength before, now;
  std::optional<TimeShift> shift;
  std::optional<FrameGap> gap;
  bool other_pace = false;  ///< the same frames at a different frame rate
  bool reversed = false;    ///< the same frames in reverse order
  int every = 1;  ///< k: the second motion has only every k-th frame of the first, at 1/k of the
                  ///< rate; −k: the first has only every k-th frame of the second; 1: neither

  bool same_length() const {
    return before.frames == now.frames &&
           same_rate(before.frames_per_second, now.frames_per_second) && before.loops == now.loops;
  }
};

/// Compares the timing. Shifts of up to half a second are considered, but at most a quarter of the
/// shorter motion. Gaps may have 1 to 3 frames, or as many as the frame counts differ by if that is
/// at most a quarter of the first motion.
TimingDifference timing_difference(const Clip& before, const Clip& now, const PairedMotions& pair);

}  // namespace mien::motion
