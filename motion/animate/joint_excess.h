#pragma once

#include <string>
#include <vector>

#include "motion/biomechanics/joint_angles.h"

namespace mien::motion {

/// By how much a change may take a joint farther out of its range, degrees.
inline constexpr double excess_tolerance_deg = 0.5;

/// How far each angle of a pose is outside its range (joint_angles.h), degrees, in the order of
/// `joint_angles`.
std::vector<double> joint_excesses(const Pose& pose);

/// "the range of the left elbow's flexion"
std::string range_in_words(const JointAngle& angle);

/// The first angle that is farther out of its range in `after` than in `before`, in words; empty if
/// there is none.
std::string joint_stop(const Pose& before, const Pose& after);

}  // namespace mien::motion
