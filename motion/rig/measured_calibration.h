#pragma once

#include <array>
#include <span>

#include "motion/rig/rig_motion.h"

namespace mien::motion {

/// Calibration constants (A_j of calibration.h) from the way the rig moves, whatever its zero pose.
struct MeasuredCalibration {
  std::array<Quat, body_joint_count> constants;
  /// Whether the joint's twist was measured itself (bent elbows and knees, flat feet) rather than
  /// inferred from its neighbours.
  std::array<bool, body_joint_count> has_evidence{};
};

MeasuredCalibration measured_calibration(std::span<const RigMotion> motions);

}  // namespace mien::motion
