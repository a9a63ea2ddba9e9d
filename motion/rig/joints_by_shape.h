#pragma once

#include "motion/rig/bone_tree.h"
#include "motion/rig/mapped_joint.h"

namespace mien::motion {

/// Finds the joints of both arms and legs that names did not identify (−1), from the shape of the
/// rig around the identified ones. If the opposite limb is known, a joint is as many joints away
/// from its known neighbours as its counterpart there. Otherwise it is, between two known joints,
/// the joint that best divides the chain between them; at the start of a limb, an ancestor of the
/// first known joint; and at its end, that child of the last known joint which has the longest
/// chain. At the end of a limb, bones must have a plausible length for a human, and twist joints
/// are excluded. Joints that were found are added to `by_shape`; joints that cannot be found stay
/// −1.
void fill_limbs_by_shape(const BoneTree& tree, KeyJoints& keys);

/// Finds the head by shape: the end of the longest chain upwards from the chest between the arms,
/// without the children of the head itself (eyes, jaw, crown). If the only joint above the chest is
/// called neck, the rig has a neck and no head. The chest and both arms must be known.
void find_head_by_shape(const BoneTree& tree, KeyJoints& keys);

}  // namespace mien::motion
