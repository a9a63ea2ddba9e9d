#pragma once

#include <optional>
#include <string>

#include "motion/rig/bone_tree.h"
#include "motion/rig/joint_word.h"
#include "motion/rig/mapped_joint.h"

namespace mien::motion {

/// Finds the key joints of a human rig from its joint names. The same word means different joints
/// in different rigs: "LeftShoulder" is the clavicle in a rig that also names an upper arm, and the
/// upper arm otherwise; "LeftFoot" is the toe joint in a rig that also names an ankle. A word has
/// the same meaning on both sides of a rig.
///
/// Joints with uninformative names are found from the shape of the rig around the others
/// (joints_by_shape.h). Empty if thighs, shanks, ankles (or tips of the shanks), upper arms and
/// forearms are not all found on both sides, or if the tree contradicts them.
std::optional<KeyJoints> key_joints_by_name(const BoneTree& tree);

/// Like the above, with bone lengths from the rig's offsets.
std::optional<KeyJoints> key_joints_by_name(const Skeleton& rig);

/// A joint of a second figure in the rig, such as "B:LeftArm" if the first has "A:LeftArm"; −1
/// unless the upper arms, forearms, thighs and shanks all have such a counterpart.
int other_figure_in(const Skeleton& rig, const KeyJoints& keys);

/// Name of the rig family, from joint names that are unique to the family: "cmu-bvh", "acclaim",
/// "bandai-namco", "xsens", "xsens-mvn" (MVNX), "optitrack-arena", "mixamo", "motionbuilder",
/// "vrm", "smpl", "biped", "mien"; "by names" when it is none of these.
std::string rig_family(const Skeleton& rig);

}  // namespace mien::motion
