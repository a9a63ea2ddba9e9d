#pragma once

#include <array>
#include <span>

#include "motion/rig/rig_motion.h"

namespace mien::motion {

/// Rotations from a rig's joint frames to those of the canonical body.
struct Calibration {
  /// Constant A_j: global rotation of canonical joint j = global rotation of the rig joint it
  /// follows · A_j. Identity for joints that follow none.
  std::array<Quat, body_joint_count> to_body;
  Skeleton body;                ///< canonical body with the performer's proportions, rig units
  bool from_rest_pose = false;  ///< the rig's zero pose is a T-pose (or arms down) and was used
};

/// Finds the constants from recordings of one and the same rig, all with the same `joints`.
///
/// Each bone of the rig is laid on `rest_direction` of its joint. The twist about the bone comes
/// from the rig's zero pose when that is a plausible standing figure. Otherwise, and wherever the
/// zero pose is off by more than 25° (feet: 12°), it is measured: thighs and shanks by the axis
/// about which the knee bends, upper arms and forearms by that of the elbow (mean over the frames
/// bent more than 15°), trunk by the lines through hips and shoulders, neck, head, clavicles and
/// hands by their mean attitude to chest and forearm, feet by standing flat. In a rig that lays its
/// limbs along axes of their joint frames, a measured reference within 20° of such an axis gives
/// way to it, so that all recordings of the rig agree.
Calibration calibrate(std::span<const RigMotion> motions);

}  // namespace mien::motion
