#include "motion/measures/distance/body_part.h"

#include <array>
#include <string_view>

namespace mien::motion {

std::string part_name(BodyJoint joint) {
  static constexpr std::array<std::string_view, body_joint_count> names = {
      "pelvis",          "lower back",     "chest",        "neck",       "head",
      "left collarbone", "left upper arm", "left forearm", "left hand",  "right collarbone",
      "right upper arm", "right forearm",  "right hand",   "left thigh", "left shin",
      "left foot",       "left toes",      "right thigh",  "right shin", "right foot",
      "right toes"};
  return std::string(names[joint]);
}

}  // namespace mien::motion
