#include <algorithm>
#include <cmath>

#include "motion/lint/checks.h"
#include "motion/lint/limb_ends.h"
#include "motion/lint/threshold_findings.h"
#include "motion/math/percentile.h"

namespace mien::motion {

namespace {

constexpr double window_seconds = 0.75;
constexpr int least_window = 15;        // frames
constexpr double least_rate = 20.0;     // Hz; below, third differences of smooth movement alternate
constexpr double alternating = -0.5;    // correlation of a third difference with the next
constexpr double chi3_median = 1.5382;  // length of a vector of three standard normal numbers

std::vector<Vec3> third_differences(const std::vector<Vec3>& path) {
  std::vector<Vec3> result;
  for (size_t t = 0; t + 3 < path.size(); ++t)
    result.push_back(path[t + 3] - 3.0 * path[t + 2] + 3.0 * path[t + 1] - path[t]);
  return result;
}

/// Standard deviation of the white noise on each coordinate of a path, metres, by the median length
/// of its third differences, whose variance is 20 times that of the noise; 0 unless consecutive
/// differences oppose each other, as those of noise do (correlation −0.75) and those of movement
/// do not.
double noise(const std::vector<Vec3>& third, int first, int last) {
  std::vector<double> lengths;
  double both = 0.0;
  double own = 0.0;
  for (int t = first; t <= last; ++t) {
    lengths.push_back(third[t].norm());
    own += third[t].squaredNorm();
    if (t < last) both += third[t].dot(third[t + 1]);
  }
  if (both > alternating * own) return 0.0;
  return percentile(lengths, 50) / (std::sqrt(20.0) * chi3_median);
}

/// Noise around each frame, metres of a stature of 1.75 m.
std::vector<double> noise_of(const LintMotion& motion, int end) {
  std::vector<double> values(motion.world.size(), 0.0);
  const std::vector<Vec3> third = third_differences(path_from_pelvis(motion, end));
  for (const FrameWindow& window : windows_of(motion, window_seconds, least_window)) {
    if (window.last - window.first + 1 < least_window) continue;
    raise_to(values, window, noise(third, window.first, window.last - 3) / motion.scale);
  }
  return values;
}

}  // namespace

Findings find_jitter(const LintMotion& motion, const LintOptions& options,
                     const LintMotion* original) {
  Findings findings;
  if (motion.rate() < least_rate) return findings;
  for (const int end : limb_ends) {
    const std::string name(name_of(BodyJoint(end)));
    const auto sentence = [&](double worst) {
      return "The " + display_name(name) + " trembles at random by " + rounded(1000.0 * worst, 1) +
             " mm (standard deviation) from frame to frame.";
    };
    const Levels levels = raised_levels(
        options.jitter_metres, original ? noise_of(*original, end) : std::vector<double>());
    add_threshold_findings(findings, motion, {"jitter", name, "m", levels, 0, 1, sentence},
                           noise_of(motion, end));
  }
  return findings;
}

}  // namespace mien::motion
