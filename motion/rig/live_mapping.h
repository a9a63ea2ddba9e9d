#pragma once

#include "motion/rig/body_mapping.h"

namespace mien::motion {

/// Maps a rig to the canonical body pose by pose, while it moves: what `recognise` and `to_body`
/// find out over a whole recording is known before.
class LiveMapping {
 public:
  /// From the hierarchy and a first pose alone: the rig's zero pose must be a standing figure
  /// (rest_calibration.h), and the first pose stand on the floor, for that is where the floor is
  /// taken to be. `first` holds one pose. Throws mien::Error for a rig that is not human, and for
  /// one that says too little.
  explicit LiveMapping(const Recording& first);

  /// From a recording of the same rig. Throws mien::Error when `first` is of another, or it is not
  /// human.
  LiveMapping(const Recording& calibration, const Recording& first);

  const BodyMapping& mapping() const { return mapping_; }

  /// The next pose of the canonical body. Rotations stay in the hemisphere of the last ones.
  Pose operator()(const Pose& pose);

 private:
  BodyMapping mapping_;
  RecordedFloor floor_;
  Recording now_;  ///< one pose
  Pose before_;    ///< on the body; without rotations before the first
};

}  // namespace mien::motion
