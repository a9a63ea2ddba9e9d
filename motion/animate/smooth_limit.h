#pragma once

#include <algorithm>
#include <cmath>

#include "motion/math/geometry.h"

namespace mien::motion {

/// The value, limited so that it stays below `limit`: unchanged up to `limit` − `margin`, from
/// there on a hyperbolic tangent, with continuous first and second derivatives. `margin` > 0.
inline double smoothly_limited(double value, double limit, double margin) {
  const double start = limit - margin;
  return value <= start ? value : start + margin * std::tanh((value - start) / margin);
}

/// The value, limited to a range; the margins are `margin`, or half of a narrower range.
inline double smoothly_within(double value, double least, double most, double margin) {
  const double own = std::min(margin, 0.5 * (most - least));
  if (!(own > 0.0)) return least;
  return -smoothly_limited(-smoothly_limited(value, most, own), -least, own);
}

/// Smooth step from 0 (x ≤ 0) to 1 (x ≥ 1), whose first and second derivatives are 0 at both ends.
inline double smoother_step(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * t * (10.0 + t * (-15.0 + 6.0 * t));
}

}  // namespace mien::motion
