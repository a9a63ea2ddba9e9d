#pragma once

#include <vector>

#include "motion/biomechanics/body_dynamics.h"
#include "motion/biomechanics/support.h"

namespace mien::motion {

/// A joint whose torque is looked at, and what strong adults can do there.
struct TorqueJoint {
  int joint;
  double limit;  ///< N·m of a body of 70 kg; others in proportion
};

/// Ankles, knees, hips, elbows, shoulders and the lower spine.
const std::vector<TorqueJoint>& torque_joints();

/// Torques, newton metres a kilogram of body, in the order of `torque_joints`: what muscles and
/// ligaments must give so that everything beyond a joint moves as it does (Newton–Euler, summed
/// over the segments beyond). The floor's force bears on the planted feet: on one of them at the
/// zero-moment point, as near as its sole comes to it; on two by the lever rule between them.
std::vector<double> joint_torques(const MovingBody& moment, const Support& support);

}  // namespace mien::motion
