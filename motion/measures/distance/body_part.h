#pragma once

#include <string>

#include "motion/skeleton/body.h"

namespace mien::motion {

/// Common name of the body part that a joint moves: "left forearm" for the left elbow, "pelvis",
/// "left toes".
std::string part_name(BodyJoint joint);

}  // namespace mien::motion
