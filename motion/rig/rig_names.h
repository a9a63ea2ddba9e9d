#pragma once

#include <optional>
#include <string>

#include "motion/rig/bone_tree.h"
#include "motion/rig/joint_word.h"
#include "motion/rig/mapped_joint.h"

namespace mien::motion {

/// The key joints of a human rig from its joint names. The same word means different joints in
/// different rigs: "LeftShoulder" is the clavicle where there is an upper arm besides, and the
/// upper arm where there is not; "LeftFoot" is the toe joint where there is an ankle besides. A
/// word means the same on both sides of a rig.
///
/// Joints whose names say nothing are found by the shape of the rig round the others
/// (joints_by_shape.h). Empty when thighs, shanks, upper arms and forearms of both sides are not
/// found so, or the tree contradicts them.
std::optional<KeyJoints> key_joints_by_name(const BoneTree& tree);

/// As above, with bones from the rig's offsets.
std::optional<KeyJoints> key_joints_by_name(const Skeleton& rig);

/// A joint of a second figure in the rig, such as "B:LeftArm" beside "A:LeftArm", if all joints of
/// arms and legs have such a twin; else −1.
int other_figure_in(const Skeleton& rig, const KeyJoints& keys);

/// Name of the rig family, from names that only that family has: "cmu-bvh", "acclaim",
/// "bandai-namco", "xsens", "optitrack-arena", "mixamo", "motionbuilder", "vrm", "smpl", "biped",
/// "mien"; "by names" when it is none of these.
std::string rig_family(const Skeleton& rig);

}  // namespace mien::motion
