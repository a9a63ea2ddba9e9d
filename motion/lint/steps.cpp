#include "motion/lint/steps.h"

#include <algorithm>

#include "motion/lint/threshold_findings.h"

namespace mien::motion {

namespace {

/// Whether step i leads over the seam of a loop.
bool leads_over_seam(const LintMotion& motion, int i) {
  return motion.was_loop && (i + 1) % motion.frames == 0;
}

}  // namespace

std::vector<double> excesses(const std::vector<Vec3>& steps) {
  std::vector<double> result;
  const int count = static_cast<int>(steps.size());
  for (int i = 0; i < count; ++i) {
    if (count < 2) return {0.0};
    const Vec3& before = steps[i > 0 ? i - 1 : i + 1];
    const Vec3& after = steps[i + 1 < count ? i + 1 : i - 1];
    const double excess = (steps[i] - 0.5 * (before + after)).norm();
    result.push_back(std::min(excess, steps[i].norm()));
  }
  return result;
}

std::vector<double> paces(const std::vector<Vec3>& steps) {
  const int count = static_cast<int>(steps.size());
  std::vector<double> result;
  for (int i = 0; i < count; ++i) {
    const Vec3& before = steps[std::max(i - 1, 0)];
    const Vec3& after = steps[std::min(i + 1, count - 1)];
    result.push_back(0.5 * (before.norm() + after.norm()));
  }
  return result;
}

std::vector<double> without_seams(const LintMotion& motion, const std::vector<double>& steps) {
  std::vector<double> values(motion.frame_count(), no_value);
  for (int i = 0; i < static_cast<int>(steps.size()); ++i) {
    if (!leads_over_seam(motion, i)) values[i + 1] = steps[i];
  }
  return values;
}

Levels at_rate(const Levels& levels, double rate) {
  const double factor = std::max(1.0, 30.0 / rate);
  return {factor * levels.warning, factor * levels.error};
}

}  // namespace mien::motion
