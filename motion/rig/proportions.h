#pragma once

#include <array>
#include <span>

#include "motion/rig/rig_motion.h"

namespace mien::motion {

/// The canonical body with the subject's bone lengths, in the rig's unit. Every offset is the mean
/// over all frames of the joint's position in the calibrated frame (`constants`, A_j of
/// calibration.h) of its parent; exact if the rig's offsets are constant.
///
/// Missing joints are filled in: a missing spine is placed at the pelvis, a missing neck at 7/10 of
/// the distance from chest to head, a missing clavicle near the midline at the height of its
/// shoulder, a missing toe 0.13 m (at 1.75 m stature) in front of the ankle and `ankle_height`
/// below it; a missing head, wrist or tip is placed by average proportions.
Skeleton proportions(std::span<const RigMotion> motions,
                     const std::array<Quat, body_joint_count>& constants);

/// Whether the canonical joint has the position of one rig joint (the first of its group) and the
/// rotation of another (the last), so that it must be aimed at its child (see
/// `canonical_rotation`).
bool is_aimed(const MappedJoint& joint);

/// World rotation of a canonical joint: that of the rig joint it follows times its constant. A
/// joint for which `is_aimed` holds is swung so that its rest direction points at the next joint.
Quat canonical_rotation(const RigMotion& motion, const JointTransforms& frame, BodyJoint joint,
                        const Quat& constant);

/// Height of the ankle above the sole at rest, rig units, for a rig without toes: the fifth
/// percentile of the ankle's height above the file's own floor (0) if that is plausible (2–7 % of
/// stature), else 4 % of stature.
double ankle_height(std::span<const RigMotion> motions, BodyJoint ankle);

}  // namespace mien::motion
