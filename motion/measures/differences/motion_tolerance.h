#pragma once

#include <string>
#include <vector>

#include "motion/measures/differences/motion_difference.h"

namespace mien::motion {

/// What of a motion's difference counts as none. Below these nobody sees it: a millimetre is half
/// a pixel of a figure of 1,000 pixels' height.
struct MotionTolerance {
  double position_m = 0.001;  ///< of joints and their virtual points, in the world
  double rotation_radians = 0.1 * radians_per_degree;  ///< of joints on their parents
  double velocity_m_s = 0.05;
  double contact_seconds = 0.05;  ///< that a foot comes down or leaves earlier or later
  double slide_m = 0.001;         ///< that a foot slides where it stood
  double duration_seconds = 0.001;
  bool any_rate = false;  ///< another frame rate is no difference
  bool any_lint = false;  ///< neither are new faults that lint calls errors
};

/// A tolerance that a difference passes.
struct Excess {
  std::string measure;  ///< "position", "rotation", "velocity", "contacts", "slide", "duration",
                        ///< "frame-rate", "loop", "joints", "lint"
  double measured = 0.0;
  double tolerance = 0.0;
  std::string unit;  ///< "m", "rad", "m/s", "s", "frames/s"; empty: a count
};

/// In the order of the measures above; empty for motions that are alike. Those that are identical
/// always are.
std::vector<Excess> excesses(const MotionDifference& difference, const MotionTolerance& tolerance);

}  // namespace mien::motion
