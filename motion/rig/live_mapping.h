#pragma once

#include "motion/rig/body_mapping.h"

namespace mien::motion {

/// Retargets a rig to the canonical body pose by pose, for live input, with a mapping determined in
/// advance.
class LiveMapping {
 public:
  /// Calibrates from the hierarchy and a first pose alone: the rig's zero pose must be a standing
  /// figure (rest_calibration.h), and the first pose must stand on the floor. `first` contains one
  /// pose. Throws mien::Error for a rig that is not human or cannot be calibrated.
  explicit LiveMapping(const Recording& first);

  /// Calibrates from a recording of the same rig. Throws mien::Error if `first` has another rig, or
  /// the rig is not human.
  LiveMapping(const Recording& calibration, const Recording& first);

  const BodyMapping& mapping() const { return mapping_; }

  /// Returns the next pose of the canonical body, without fingers. Each quaternion has the sign
  /// with which its dot product with that of the previous pose is not negative.
  Pose operator()(const Pose& pose);

 private:
  BodyMapping mapping_;
  RecordedFloor floor_;
  Recording now_;  ///< one pose
  Pose before_;    ///< previous pose of the canonical body; without rotations before the first call
};

}  // namespace mien::motion
