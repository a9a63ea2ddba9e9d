#include "motion/formats/frame_rate.h"

#include <array>
#include <cmath>

namespace mien::motion {

double snapped_frame_rate(double frames_per_second) {
  constexpr double tolerance = 0.001 + 1e-9;
  const std::array<double, 5> candidates = {std::round(frames_per_second), 24000.0 / 1001.0,
                                            30000.0 / 1001.0, 60000.0 / 1001.0, 120000.0 / 1001.0};
  double best = frames_per_second;
  double smallest = tolerance;
  for (const double candidate : candidates) {
    // Relative to the frame time, the number that was rounded when the file was written.
    const double gap = std::abs(candidate / frames_per_second - 1.0);
    if (candidate > 0.0 && gap <= smallest) {
      best = candidate;
      smallest = gap;
    }
  }
  return best;
}

}  // namespace mien::motion
