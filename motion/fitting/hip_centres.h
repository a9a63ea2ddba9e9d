#pragma once

#include <optional>

#include "motion/math/geometry.h"

namespace mien::motion {

/// Measures of a subject, metres.
struct PelvisMeasures {
  double width = 0.0;  ///< between the front iliac spines (ASIS)
  double depth = 0.0;  ///< from the middle of the front spines to that of the back ones (PSIS)
  std::optional<double> leg_length;  ///< front iliac spine – knee – ankle
};

/// The centre of the left or right hip joint by Harrington et al. 2007 ("Prediction of the hip
/// joint centre in adults, children, and patients with cerebral palsy based on magnetic resonance
/// imaging", J. Biomech. 40:595–602), mean error in adults 5 mm along each axis.
///
/// In the pelvic frame: origin midway between the front iliac spines; x to the subject's left along
/// the line of the front spines; z forward, in the plane through the front spines and the middle of
/// the back spines; y up, perpendicular to that plane. Metres. With depth d, width w and leg length
/// l in mm:
///
///   forward  −0.24 d − 9.9
///   up       −0.16 w − 0.04 l − 7.1, or −0.30 w − 10.9 if the leg length is unknown
///   outward   0.28 d + 0.16 w + 7.9
Vec3 hip_centre(const PelvisMeasures& measures, bool left);

}  // namespace mien::motion
