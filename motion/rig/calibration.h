#pragma once

#include <array>
#include <span>

#include "motion/rig/rig_motion.h"

namespace mien::motion {

/// Rotations from a rig's joint frames to those of the canonical body.
struct Calibration {
  /// Constant A_j: global rotation of canonical joint j = global rotation of the corresponding rig
  /// joint · A_j. Identity for joints without a corresponding rig joint.
  std::array<Quat, body_joint_count> to_body;
  Skeleton body;                ///< canonical body with the subject's proportions, rig units
  bool from_rest_pose = false;  ///< whether the zero pose (T-pose or arms down) was used
};

/// What the zero pose of a rig is worth.
enum class ZeroPose {
  checked,  ///< a plausible figure, unless the motion contradicts it
  defined,  ///< the format defines it, as SMPL its T-pose: only the feet are checked
  own,      ///< the rig is the canonical body: nothing is measured, all constants are the identity
};

/// Finds the constants from recordings of one rig, all with the same `joints`.
///
/// Each bone of the rig is aligned with `rest_direction` of its joint. The twist about the bone is
/// taken from the rig's zero pose if that is a plausible standing figure. Otherwise, and for joints
/// where the zero pose differs from a direct measurement by more than 25° (feet: 12°), it is
/// measured: for thighs and shanks from the flexion axis of the knee, for upper arms and forearms
/// from that of the elbow (mean over frames with more than 15° of flexion), for the trunk from the
/// lines through hips and shoulders, for neck, head, clavicles and hands from their mean
/// orientation relative to chest and forearm, for feet from standing flat. A zero pose that the
/// format defines is measured for the feet only, and that of the canonical body not at all: what
/// was calibrated once stays as it is when it is written and read again. If the rig aligns its
/// limbs with axes of their joint frames, a measured reference near such an axis is replaced by
/// that axis, so that all recordings of the rig agree.
Calibration calibrate(std::span<const RigMotion> motions, ZeroPose zero_pose = ZeroPose::checked);

}  // namespace mien::motion
