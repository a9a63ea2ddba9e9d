#pragma once

#include <string>

#include "motion/skeleton/body.h"

namespace mien::motion {

/// What a joint carries, as people call it: "left forearm" of the left elbow, "pelvis", "left
/// toes".
std::string part_name(BodyJoint joint);

}  // namespace mien::motion
