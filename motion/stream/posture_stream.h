#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "motion/modify/modification.h"

namespace mien::motion {

/// Puts another posture on a motion as `with_posture` does, a frame at a time and `look_ahead`
/// frames late. How much of it a limb takes is smoothed over what has come so far, as if the motion
/// ended there: without look-ahead it is what the moment says. Trunk and head need no look-ahead.
class PostureStream {
 public:
  PostureStream(const Modification& modification, const Skeleton& body, double frames_per_second,
                int look_ahead);

  /// Takes the next frame and gives, once `look_ahead` have passed, the frame that many before it.
  std::optional<Pose> push(Pose pose);

  /// The frames that have not been given yet. Nothing may be pushed after it.
  std::vector<Pose> finish();

 private:
  Pose next();

  std::vector<PostureChange> changes_;
  std::optional<PoseDifference> difference_;
  LimbFade fade_;
  double frames_per_second_;
  int look_ahead_;
  std::deque<Pose> waiting_;             ///< from the frame that is given next to the newest
  std::deque<LimbStrengths> strengths_;  ///< those of `waiting_`, and of some before
};

}  // namespace mien::motion
