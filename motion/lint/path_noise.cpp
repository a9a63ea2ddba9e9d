#include "motion/lint/path_noise.h"

#include <cmath>

#include "motion/lint/limb_ends.h"
#include "motion/math/percentile.h"

namespace mien::motion {

namespace {

constexpr double window_seconds = 0.75;
constexpr int least_window = 15;        // frames
constexpr double alternating = -0.5;    // mean cosine between third differences
constexpr double chi3_median = 1.5382;  // length of a vector of three standard normal numbers

std::vector<Vec3> third_differences(const std::vector<Vec3>& path) {
  std::vector<Vec3> result;
  for (size_t t = 0; t + 3 < path.size(); ++t)
    result.push_back(path[t + 3] - 3.0 * path[t + 2] + 3.0 * path[t + 1] - path[t]);
  return result;
}

/// Whether consecutive third differences point in opposite directions on the average, as those of
/// noise do (correlation −0.75). Their lengths do not count, or a foot that lands would do.
bool alternate(const std::vector<Vec3>& third, int first, int last) {
  double cosines = 0.0;
  for (int t = first; t < last; ++t) {
    cosines += third[t].normalized().dot(third[t + 1].normalized());
  }
  return cosines <= alternating * (last - first);
}

/// Standard deviation of white noise on each coordinate of a path with third differences of this
/// median length, metres; their variance is 20 times that of the noise.
double noise_of_median(const std::vector<Vec3>& third, int first, int last) {
  std::vector<double> lengths;
  for (int t = first; t <= last; ++t) lengths.push_back(third[t].norm());
  return percentile(lengths, 50) / (std::sqrt(20.0) * chi3_median);
}

std::vector<double> by_windows(const LintMotion& motion, int end, bool only_noise) {
  std::vector<double> values(motion.world.size(), 0.0);
  const std::vector<Vec3> third = third_differences(path_from_pelvis(motion, end));
  for (const FrameWindow& window : windows_of(motion, window_seconds, least_window)) {
    if (window.last - window.first + 1 < least_window) continue;
    const int last = window.last - 3;
    if (only_noise && !alternate(third, window.first, last)) continue;
    raise_to(values, window, noise_of_median(third, window.first, last) / motion.scale);
  }
  return values;
}

}  // namespace

std::vector<double> path_noise(const LintMotion& motion, int end) {
  return by_windows(motion, end, true);
}

std::vector<double> path_roughness(const LintMotion& motion, int end) {
  return by_windows(motion, end, false);
}

}  // namespace mien::motion
