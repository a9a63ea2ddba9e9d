#pragma once

#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Minimum speed of the floor under a walk in place, m/s; slower movement of the feet is sway.
inline constexpr double slowest_treadmill_m_s = 0.25;

/// A motion prepared for the checks: its rotations are normalised; a loop is repeated to three
/// laps, so that the middle lap has neighbours on both sides; if the body is the canonical one, a
/// walk in place is converted to a travelling walk.
struct LintMotion {
  Clip clip;       ///< does not loop
  int frames = 0;  ///< number of frames of the motion as given
  int start = 0;   ///< index in `clip` of the first of these frames; of a loop: in the middle lap
  bool was_loop = false;
  std::vector<JointTransforms> world;  ///< world transforms for every frame of `clip`
  double scale = 1.0;         ///< stature divided by 1.75 m; 1 if the body is not the canonical one
  Vec3 floor = Vec3::Zero();  ///< m/s; velocity of the floor under a motion in place

  int frame_count() const { return clip.frame_count(); }
  double rate() const { return clip.frames_per_second; }
  /// World positions of a joint, one per frame of `clip`, metres.
  std::vector<Vec3> path(int joint) const;
};

/// Prepares a motion. Its numbers must be finite and its rotations non-zero, and it must have at
/// least one frame.
LintMotion lint_motion(const Clip& motion);

/// The frame of `other` that corresponds to `frame` of `motion`: at the same fraction of the
/// motion's duration, in the same lap; fractional, and within the frames of `other.clip`.
double corresponding_frame(const LintMotion& motion, double frame, const LintMotion& other);

/// Seconds of `other` that correspond to one second of `motion`: 1 if both have the same duration.
double pace(const LintMotion& motion, const LintMotion& other);

}  // namespace mien::motion
