#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "render/video/video.h"

namespace mien::render {

FrameRate frame_rate(double per_second) {
  if (!(per_second > 0.0) || !std::isfinite(per_second)) {
    throw std::invalid_argument("frame_rate: not positive");
  }
  const double whole = std::round(per_second);
  if (whole >= 1.0 && std::abs(per_second - whole) < 1e-6 * whole) {
    return {static_cast<int>(whole), 1};
  }
  const double ntsc = std::round(per_second * 1.001);
  if (std::abs(per_second - ntsc / 1.001) < 1e-4 * per_second) {
    return {static_cast<int>(ntsc) * 1000, 1001};
  }
  FrameRate best{static_cast<int>(std::max(1.0, whole)), 1};
  for (int denominator = 1; denominator <= 1000; ++denominator) {
    const FrameRate rate{static_cast<int>(std::round(per_second * denominator)), denominator};
    if (rate.numerator > 0 && std::abs(rate.per_second() - per_second) <
                                  std::abs(best.per_second() - per_second) - 1e-12) {
      best = rate;
    }
  }
  return best;
}

}  // namespace mien::render
