#pragma once

#include <vector>

#include "motion/biomechanics/body_dynamics.h"
#include "motion/biomechanics/support.h"

namespace mien::motion {

/// A joint whose torque is checked, with the limit of strong adults.
struct TorqueJoint {
  int joint;
  double limit;  ///< N·m for a body mass of 70 kg; others in proportion
};

/// Ankles, knees, hips, elbows, shoulders and the lower spine.
const std::vector<TorqueJoint>& torque_joints();

/// Joint torques, newton metres per kg of body mass, in the order of `torque_joints`: the net
/// torques of muscles and ligaments by inverse dynamics (Newton–Euler, summed over the distal
/// segments). The ground reaction force acts on the planted feet: on a single foot at the point of
/// its sole nearest to the zero-moment point, on two feet divided by the lever rule.
std::vector<double> joint_torques(const BodyDynamics& moment, const Support& support);

}  // namespace mien::motion
