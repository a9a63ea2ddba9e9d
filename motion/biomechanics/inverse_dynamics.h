#pragma once

#include <vector>

#include "motion/biomechanics/body_dynamics.h"
#include "motion/biomechanics/support.h"

namespace mien::motion {

/// A joint whose torque is checked, and the limit for strong adults.
struct TorqueJoint {
  int joint;
  double limit;  ///< N·m for a body mass of 70 kg; proportional to body mass
};

/// Ankles, knees, hips, elbows, shoulders and the lower spine.
const std::vector<TorqueJoint>& torque_joints();

/// Magnitudes of the net joint torques of muscles and ligaments, newton metres per kg of body mass,
/// in the order of `torque_joints`; by inverse dynamics (Newton–Euler, summed over the distal
/// segments). The ground reaction force acts on each foot that bears weight, at the point of its
/// contact area nearest to the zero-moment point; if both feet bear weight, the force is divided
/// between them by the lever rule.
std::vector<double> joint_torques(const BodyDynamics& moment, const Support& support);

}  // namespace mien::motion
