#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "motion/rig/mapped_joint.h"

namespace mien::motion {

/// What a joint's name says, whatever rig it comes from.
struct JointWord {
  enum class Side { middle, left, right };
  Side side = Side::middle;
  std::string word;  ///< lower case, without side, name space, numbers and padding: "upleg", "hips"
};

/// Reads a joint name in the spellings of common rigs: "LeftUpLeg", "mixamorig:LeftUpLeg",
/// "UpperLeg_L", "lfemur", "Bip01 L Thigh", "J_Bip_L_UpperLeg", "thigh.L", "left_hip".
JointWord joint_word(std::string_view name);

/// The key joints of a human rig from its joint names. The same word means different joints in
/// different rigs: "LeftShoulder" is the clavicle where there is an upper arm besides, and the
/// upper arm where there is not; "LeftFoot" is the toe joint where there is an ankle besides. Empty
/// when the names do not give both thighs, shanks, upper arms and forearms, or the tree contradicts
/// them.
std::optional<KeyJoints> key_joints_by_name(const Skeleton& rig);

/// Name of the rig family, from names that only that family has: "cmu-bvh", "acclaim",
/// "bandai-namco", "xsens", "optitrack-arena", "mixamo", "motionbuilder", "vrm", "smpl", "biped",
/// "mien"; "by names" when it is none of these.
std::string rig_family(const Skeleton& rig);

}  // namespace mien::motion
