#pragma once

#include <vector>

#include "motion/biomechanics/body_dynamics.h"
#include "motion/biomechanics/support.h"

namespace mien::motion {

/// What the checks of balance and forces look at, frame by frame.
struct BodyOnFloor {
  std::vector<MovingBody> moments;
  std::vector<Support> supports;
};

BodyOnFloor body_on_floor(const LintSubject& subject);

/// Makes nothing (NaN) of the first and last 0.1 s of a motion that does not loop: accelerations
/// are guesses there.
void without_ends(const LintSubject& subject, std::vector<double>& values);

}  // namespace mien::motion
