#pragma once

#include <array>
#include <span>

#include "motion/rig/rig_motion.h"

namespace mien::motion {

/// Calibration constants (A_j of calibration.h) measured from the motion of the rig, independent of
/// its zero pose.
struct MeasuredCalibration {
  std::array<Quat, body_joint_count> constants;
  /// Whether the joint's twist was measured directly (bent elbows and knees, flat feet) rather than
  /// inferred from neighbouring joints.
  std::array<bool, body_joint_count> has_evidence{};
};

MeasuredCalibration measured_calibration(std::span<const RigMotion> motions);

}  // namespace mien::motion
