#pragma once

#include <array>
#include <span>

#include "motion/rig/rig_motion.h"

namespace mien::motion {

/// The canonical body with the performer's bone lengths, in the rig's unit: every offset is the
/// mean over all frames of what the rig shows in the calibrated frame (`constants`, A_j of
/// calibration.h) of the parent; exact when the rig's offsets are constant.
///
/// Missing joints are filled in: a missing spine sits at the pelvis, a missing neck at 7/10 of
/// the way from chest to head, a missing clavicle near the midline level with its shoulder, a
/// missing toe 0.13 m (at 1.75 m stature) before the ankle on the floor; a missing head, wrist or
/// tip by average proportions.
Skeleton proportions(std::span<const RigMotion> motions,
                     const std::array<Quat, body_joint_count>& constants);

/// Whether the canonical joint is turned by several rig joints in a row while sitting at the first,
/// so that it must be aimed at its child (see `aimed`).
bool is_aimed(const MappedJoint& joint);

/// World rotation of a canonical joint: that of the rig joint it follows times its constant. A
/// joint of several rig joints is swung so that its rest direction points at the next joint.
Quat canonical_rotation(const RigMotion& motion, const JointTransforms& frame, BodyJoint joint,
                        const Quat& constant);

/// Height of the ankle above the sole at rest when the rig has no toe to tell: the lowest stance of
/// the ankle above the file's own floor (0) when that is plausible (2–7 % of stature), else 4 %.
double ankle_height(std::span<const RigMotion> motions, BodyJoint ankle);

}  // namespace mien::motion
