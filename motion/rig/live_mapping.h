#pragma once

#include "motion/rig/body_mapping.h"

namespace mien::motion {

/// Maps a rig to the canonical body pose by pose, for live input, with a mapping that is determined
/// beforehand.
class LiveMapping {
 public:
  /// Calibrates from the hierarchy and a first pose alone: the rig's zero pose must be a standing
  /// figure (rest_calibration.h), and the first pose must stand on the floor. `first` contains one
  /// pose. Throws mien::Error for a rig that is not human or cannot be calibrated.
  explicit LiveMapping(const Recording& first);

  /// Calibrates from a recording of the same rig. Throws mien::Error when `first` is of another
  /// rig, or it is not human.
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
