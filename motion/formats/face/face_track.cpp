#include "motion/formats/face/face_track.h"

#include <algorithm>
#include <cstddef>

namespace mien::motion {

double weight_at(const FaceCurve& curve, double seconds) {
  const bool is_spline = curve.interpolation == FaceCurve::Interpolation::cubic_spline;
  const auto number = [&](std::size_t key, std::size_t which) {
    return is_spline ? curve.values[3 * key + which] : curve.values[key];
  };
  const auto after = std::ranges::upper_bound(curve.times, seconds);
  if (after == curve.times.begin()) return number(0, 1);
  const auto key = static_cast<std::size_t>(after - curve.times.begin()) - 1;
  const bool is_held = curve.interpolation == FaceCurve::Interpolation::step;
  if (after == curve.times.end() || is_held) return number(key, 1);
  const double length = curve.times[key + 1] - curve.times[key];
  const double t = (seconds - curve.times[key]) / length;
  const double from = number(key, 1), to = number(key + 1, 1);
  if (!is_spline) return from + t * (to - from);
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * from + length * (t3 - 2 * t2 + t) * number(key, 2) +
         (-2 * t3 + 3 * t2) * to + length * (t3 - t2) * number(key + 1, 0);
}

}  // namespace mien::motion
