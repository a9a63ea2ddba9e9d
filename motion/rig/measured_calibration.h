#pragma once

#include <array>
#include <span>

#include "motion/rig/rig_motion.h"

namespace mien::motion {

/// Calibration constants (A_j of calibration.h) from the way the rig moves, whatever its zero pose.
struct MeasuredCalibration {
  std::array<Quat, body_joint_count> constants;
  /// Whether the twist of the joint rests on evidence of its own (bent elbows and knees, feet on
  /// the floor) rather than on its neighbours.
  std::array<bool, body_joint_count> has_evidence{};
};

MeasuredCalibration measured_calibration(std::span<const RigMotion> motions);

}  // namespace mien::motion
