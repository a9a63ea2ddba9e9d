#include "motion/animate/joint_excess.h"

#include <algorithm>

namespace mien::motion {

std::vector<double> joint_excesses(const Pose& pose) {
  std::vector<double> values = measured_angles(pose);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const JointAngle& angle = joint_angles()[i];
    values[i] = std::max({0.0, angle.least_degrees - values[i], values[i] - angle.most_degrees});
  }
  return values;
}

std::string range_in_words(const JointAngle& angle) {
  std::string joint;
  for (const char c : name_of(angle.joint)) {
    const bool is_upper = c >= 'A' && c <= 'Z';
    if (is_upper && !joint.empty()) joint += ' ';
    joint += is_upper ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return "the range of the " + joint + "'s " + std::string(angle.name);
}

std::string joint_stop(const Pose& before, const Pose& after) {
  const std::vector<double> then = joint_excesses(before);
  const std::vector<double> now = joint_excesses(after);
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i] > then[i] + excess_tolerance_deg) return range_in_words(joint_angles()[i]);
  }
  return "";
}

}  // namespace mien::motion
