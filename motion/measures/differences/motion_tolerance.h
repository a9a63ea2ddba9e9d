#pragma once

#include <string>
#include <vector>

#include "motion/measures/differences/motion_difference.h"

namespace mien::motion {

/// Differences up to these count as none because they are not visible: a millimetre is half
/// a pixel of a figure of 1,000 pixels' height.
struct MotionTolerance {
  double position_m = 0.001;  ///< of joints and their virtual points, in the world
  double rotation_radians = 0.1 * radians_per_degree;  ///< of joints on their parents
  double velocity_m_s = 0.05;
  double contact_seconds = 0.05;  ///< that a foot comes down or leaves earlier or later
  double slide_m = 0.001;         ///< that a foot slides where it stood
  double duration_seconds = 0.001;
  bool any_rate = false;  ///< ignore another frame rate
  bool any_lint = false;  ///< ignore new lint errors
};

/// A tolerance that a difference exceeds.
struct Excess {
  std::string measure;  ///< "position", "rotation", "velocity", "contacts", "slide", "duration",
                        ///< "frame-rate", "loop", "joints", "lint"
  double measured = 0.0;
  double tolerance = 0.0;
  std::string unit;  ///< "m", "rad", "m/s", "s", "frames/s"; empty: a count
};

/// The exceeded tolerances, in the order of the measures above; empty for motions that are equal
/// within the tolerance.
std::vector<Excess> excesses(const MotionDifference& difference, const MotionTolerance& tolerance);

}  // namespace mien::motion
