#pragma once

#include <string>
#include <vector>

#include "motion/skeleton/body.h"
#include "motion/skeleton/pose.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// A motion of the canonical body (body.h): metres, +Y up, the floor at y = 0. Bone lengths never
/// change: poses carry no offsets of their own.
///
/// Frame i is at i / frames_per_second seconds. A clip that `loops` holds one cycle without its
/// last, repeated frame: frame n is frame 0 again, `cycle_displacement` further on.
struct Clip {
  std::string name;
  Skeleton body;
  double frames_per_second = 30.0;
  std::vector<Pose> poses;
  bool loops = false;
  Vec3 cycle_displacement = Vec3::Zero();  ///< metres per cycle; zero when in place

  int frame_count() const { return static_cast<int>(poses.size()); }

  /// Looping: frames/fps. Otherwise from the first frame to the last.
  double duration_seconds() const {
    return (loops ? frame_count() : frame_count() - 1) / frames_per_second;
  }
};

/// The pose at a time, interpolated between frames. A looping clip repeats in both directions, each
/// cycle displaced; another is clamped at its ends.
Pose pose_at(const Clip& clip, double seconds);

/// The clip at another frame rate: slerp for rotations, cubic (Catmull–Rom) for the root. A looping
/// clip keeps its duration to the nearest whole frame; another ends with the last frame that lies
/// within it.
Clip resampled(const Clip& clip, double frames_per_second);

/// `cycles` repetitions of a looping clip in a row, as a clip that does not loop.
Clip repeated(const Clip& loop, int cycles);

/// World positions of all joints, frame by frame.
std::vector<std::vector<Vec3>> joint_paths(const Clip& clip);

/// The clip as a recording for the file writers: metres, joint names of the body.
Recording to_recording(const Clip& clip);

}  // namespace mien::motion
