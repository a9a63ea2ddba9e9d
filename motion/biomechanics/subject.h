#pragma once

#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Least floor speed of a walk in place; slower movement is sway.
inline constexpr double slowest_treadmill_m_s = 0.25;

/// A motion prepared for the checks: unit rotations; a loop unrolled to three laps, so that the
/// middle one has both neighbours; a walk in place converted to a travelling one.
struct LintSubject {
  Clip clip;       ///< does not loop
  int frames = 0;  ///< of the motion that was given
  int start = 0;   ///< frame of `clip` at which that motion begins: its middle lap
  bool was_loop = false;
  std::vector<JointTransforms> world;  ///< of every frame of `clip`
  double scale = 1.0;         ///< stature divided by 1.75 m; 1 when it is not the canonical body
  Vec3 floor = Vec3::Zero();  ///< m/s; of the floor under a motion given in place

  int frame_count() const { return clip.frame_count(); }
  double rate() const { return clip.frames_per_second; }
  /// World positions of one joint.
  std::vector<Vec3> path(int joint) const;
};

/// Prepares a motion. Its numbers must be finite, its rotations not zero, and it has at least one
/// frame.
LintSubject lint_subject(const Clip& motion);

/// Frame of `other` that corresponds to `frame` of `subject`: at the same share of the motion's
/// duration, same lap.
double corresponding_frame(const LintSubject& subject, double frame, const LintSubject& other);

/// Seconds of `other` that one second of `subject` corresponds to: 1 unless the tempo was changed.
double pace(const LintSubject& subject, const LintSubject& other);

}  // namespace mien::motion
