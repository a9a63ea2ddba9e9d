#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "motion/points/marker_sets.h"

namespace mien::motion {

/// The roles of points that are named like the joints of a rig (motion/rig/joint_word.h), as those
/// of tables that were written from a BVH, FBX or glTF file: "mixamorig:LeftUpLeg", "UpperLeg_L",
/// "lfemur", "Bip01 L Thigh". Words mean what they mean in a rig (motion/rig/rig_names.h):
/// "LeftShoulder" is a clavicle where there is an upper arm, too; of the joints of the back between
/// pelvis and neck, the lowest is the spine and the first of the upper half is the chest, the
/// others have no role.
///
/// Empty unless thigh, shank, foot or ankle, upper arm and forearm are named on both sides.
std::vector<std::optional<Role>> rig_joint_roles(std::span<const std::string> names);

}  // namespace mien::motion
