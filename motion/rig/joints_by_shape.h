#pragma once

#include "motion/rig/bone_tree.h"
#include "motion/rig/mapped_joint.h"

namespace mien::motion {

/// Finds those joints of both arms and legs that names did not identify (−1), from the shape of the
/// rig around the identified ones: as many joints on as on the other side where that is known, else
/// the joint between two known ones that parts them best, the joint above, or the longest way on.
/// An end (wrist, ankle, toe) has to lie where a human's would; a twist joint is none. Adds what it
/// finds to `by_shape`. Joints that cannot be found stay −1.
void fill_limbs_by_shape(const BoneTree& tree, KeyJoints& keys);

/// Finds the head by shape: the end of the longest way up from the chest between the arms, before
/// what the head itself carries (eyes, jaw, the end of its crown). A chest with one joint called
/// neck above has a neck and no head. The pelvis, the chest and both arms are known.
void find_head_by_shape(const BoneTree& tree, KeyJoints& keys);

}  // namespace mien::motion
