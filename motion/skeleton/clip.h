#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/skeleton/body.h"
#include "motion/skeleton/markers.h"
#include "motion/skeleton/pose.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// A motion in metres, +Y up, the floor at y = 0; of the canonical body (body.h) unless stated
/// otherwise, as for `clip_of`. In motions of the canonical body, bone lengths are constant:
/// poses have no offsets of their own.
///
/// Frame i is at i / frames_per_second seconds. A clip that `loops` holds one cycle without the
/// repeated last frame: the last frame is followed by frame 0, displaced by `cycle_displacement`.
struct Clip {
  std::string name;
  Skeleton body;
  double frames_per_second = 30.0;
  std::vector<Pose> poses;
  bool loops = false;
  Vec3 cycle_displacement = Vec3::Zero();  ///< metres per cycle; zero when in place
  /// Of the recording that the motion was made from; to be read with markers_of (clip_markers.h).
  std::optional<Markers> markers = {};

  int frame_count() const { return static_cast<int>(poses.size()); }

  /// Duration of a cycle if the clip loops, otherwise from the first frame to the last.
  double duration_seconds() const {
    return (loops ? frame_count() : frame_count() - 1) / frames_per_second;
  }
};

/// The pose at a time, interpolated between frames. A looping clip repeats in both directions, with
/// each cycle displaced; for any other clip the time is clamped to its ends.
Pose pose_at(const Clip& clip, double seconds);

/// The clip at another frame rate: slerp for rotations, cubic (Catmull–Rom) for the root. The
/// duration of a looping clip is rounded to whole frames; any other clip ends at the last new frame
/// within its duration.
Clip resampled(const Clip& clip, double frames_per_second);

/// `cycles` consecutive repetitions of a looping clip, as a clip that does not loop.
Clip repeated(const Clip& loop, int cycles);

/// The frames from `first` to `last` of a clip.
Clip cut(const Clip& clip, int first, int last);

/// World positions of all joints, frame by frame.
std::vector<std::vector<Vec3>> joint_paths(const Clip& clip);

/// The clip as a recording for the file writers: metres, joint names of the body.
Recording to_recording(const Clip& clip);

}  // namespace mien::motion
