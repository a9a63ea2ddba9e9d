#pragma once

#include <array>
#include <optional>

#include "motion/rig/rig_motion.h"

namespace mien::motion {

/// Calibration constants (A_j of calibration.h) from the rig's zero pose; empty unless it is a
/// plausible standing figure: trunk and legs along one line (legs may be spread by up to 40°), arms
/// sideways or down, feet forward. Canonical frames are aligned with their bones by the
/// shortest rotation; feet, hands and head have rules of their own.
std::optional<std::array<Quat, body_joint_count>> rest_calibration(const RigMotion& motion);

}  // namespace mien::motion
