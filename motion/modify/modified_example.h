#pragma once

#include <vector>

#include "motion/modify/modification.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

/// A modified motion with its keytimes.
struct ModifiedExample {
  Example example;
  std::vector<double> times;  ///< given times of the original, in the result, seconds
  ModificationReport report;
};

/// Modifies a motion of the canonical body; its keytimes, and `times` (seconds), are moved with it.
/// Throws Error as `modify` does.
ModifiedExample modified_example(const Example& original, const Modification& modification,
                                 std::vector<double> times = {});

/// The modification without its change of a gesture if no hand of the clip makes one: what a recipe
/// says of gestures is not meant for walks.
Modification without_idle_gesture(Modification modification, const Clip& clip);

}  // namespace mien::motion
