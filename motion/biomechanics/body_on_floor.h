#pragma once

#include <vector>

#include "motion/biomechanics/body_dynamics.h"
#include "motion/biomechanics/support.h"

namespace mien::motion {

/// Dynamics and support of a subject, frame by frame: the input of the checks of balance and
/// forces.
struct BodyOnFloor {
  std::vector<BodyDynamics> moments;
  std::vector<Support> supports;
};

BodyOnFloor body_on_floor(const LintSubject& subject);

/// Sets the values of the first and last 0.1 s to NaN, unless the motion loops: accelerations are
/// unreliable there.
void mask_ends(const LintSubject& subject, std::vector<double>& values);

}  // namespace mien::motion
