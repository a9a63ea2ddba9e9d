#pragma once

#include <string>
#include <vector>

#include "motion/measures/differences/motion_difference.h"

namespace mien::motion {

/// Differences up to these tolerances are ignored because they are not visible: a millimetre is
/// about half a pixel for a figure 1,000 pixels high.
struct MotionTolerance {
  double position_m = 0.001;  ///< of joints and their virtual points, world space
  double rotation_radians = 0.1 * radians_per_degree;  ///< of joints relative to their parents
  double velocity_m_s = 0.05;
  double contact_seconds = 0.05;  ///< change in the time at which a foot lands or lifts off; length
                                  ///< of a plant that is new or gone
  double slide_m = 0.001;         ///< additional slide of a planted foot
  double duration_seconds = 0.001;
  bool any_rate = false;  ///< whether to ignore a different frame rate
  bool any_lint = false;  ///< whether to ignore new lint errors
};

/// A tolerance that a difference exceeds.
struct Excess {
  std::string measure;  ///< "position", "rotation", "velocity", "contacts", "slide", "duration",
                        ///< "frame-rate", "loop", "joints", "lint"
  double measured = 0.0;
  double tolerance = 0.0;
  std::string unit;  ///< "m", "rad", "m/s", "s", "frames/s"; empty: a count
};

/// The exceeded tolerances, in the order listed in Excess::measure; empty if the motions are equal
/// within the tolerance.
std::vector<Excess> excesses(const MotionDifference& difference, const MotionTolerance& tolerance);

}  // namespace mien::motion
