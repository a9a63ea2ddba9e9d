#pragma once

#include <string>

#include "motion/measures/differences/motion_difference.h"

namespace mien::motion {

/// The largest change of a motion in one line: "left forearm twisted by up to 1.0°, at 0.43 s".
///
/// Changes of the whole motion take precedence: delayed or missing frames, the same frames at a
/// different rate or in reverse order, exchanged sides, a different scale, a displaced figure whose
/// poses are unchanged. Otherwise the line names a changed bone or, if there is none, the joint
/// with the largest local rotation; a displaced figure and a sliding foot are added. It is "no
/// difference" if the motions are identical.
std::string largest_change(const MotionDifference& difference);

/// "1.0°", "0.25°", "under 0.001°"
std::string in_degrees(double radians);
/// "12.3 cm", "0.25 cm"
std::string in_centimetres(double metres);
/// "0.43 s"
std::string in_seconds(double seconds);

}  // namespace mien::motion
