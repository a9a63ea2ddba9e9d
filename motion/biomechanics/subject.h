#pragma once

#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A floor that would move more slowly is none: the body sways.
inline constexpr double slowest_treadmill_m_s = 0.25;

/// A motion as the checks look at it: rotations unit, a loop three times round so that its middle
/// lap has both neighbours, and travelling, if it walked in place.
struct LintSubject {
  Clip clip;       ///< does not loop
  int frames = 0;  ///< of the motion that was given
  int start = 0;   ///< frame of `clip` at which that motion begins: its middle lap
  bool was_loop = false;
  std::vector<JointTransforms> world;  ///< of every frame of `clip`
  double scale = 1.0;                  ///< stature by 1.75 m; 1 when it is not the canonical body
  Vec3 floor = Vec3::Zero();           ///< m/s; what the floor would do under the motion as it was
                                       ///< given, where that walks on the spot

  int frame_count() const { return clip.frame_count(); }
  double rate() const { return clip.frames_per_second; }
  /// World positions of one joint.
  std::vector<Vec3> path(int joint) const;
};

/// All numbers of the motion must be finite and its rotations no zero quaternions; at least one
/// frame.
LintSubject lint_subject(const Clip& motion);

/// Frame of `other` that corresponds to `frame` of `subject`: at the same share of the motion's
/// duration, same lap.
double corresponding_frame(const LintSubject& subject, double frame, const LintSubject& other);

/// How many seconds of `other` one second of `subject` corresponds to: 1 unless it was slowed down
/// or hurried.
double pace(const LintSubject& subject, const LintSubject& other);

}  // namespace mien::motion
