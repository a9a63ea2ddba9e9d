#include <algorithm>
#include <cmath>

#include "motion/lint/against_original.h"
#include "motion/lint/checks.h"
#include "motion/lint/stretches.h"
#include "motion/math/filter.h"
#include "motion/math/percentile.h"

namespace mien::motion {

namespace {

constexpr double jerk_window_seconds = 0.5;
constexpr double smooth_jerk = 10.0;  // m/s³; what is smoother is as good as still

/// Root mean square of the jerk around each frame, m/s³.
std::vector<double> jerks(const LintSubject& subject, int joint) {
  const double rate = subject.rate();
  std::vector<Vec3> way = low_pass(limb_way(subject, joint), std::min(10.0, 0.3 * rate), rate);
  for (int order = 0; order < 3; ++order) way = derivative(way, rate);
  const int count = static_cast<int>(way.size());
  const int reach = static_cast<int>(std::lround(0.5 * jerk_window_seconds * rate));
  std::vector<double> values;
  for (int t = 0; t < count; ++t) {
    const int first = std::max(0, t - reach);
    const int last = std::min(count - 1, t + reach);
    double sum = 0.0;
    for (int i = first; i <= last; ++i) sum += way[i].squaredNorm();
    values.push_back(std::sqrt(sum / (last - first + 1)));
  }
  return values;
}

}  // namespace

Findings find_jerks(const LintSubject& subject, const LintOptions& options,
                    const LintSubject& original) {
  Findings findings;
  for (const int joint : limb_ends) {
    const double usual = std::max(percentile(jerks(original, joint), 90), smooth_jerk);
    std::vector<double> ratios = jerks(subject, joint);
    for (double& value : ratios) value /= usual;
    const std::string name(name_of(BodyJoint(joint)));
    const auto sentence = [&](double worst) {
      return "The " + spoken(name) + " moves " + rounded(worst, 1) +
             " times as jerkily as in the original.";
    };
    add_stretches(findings, subject, {"jerk", name, "", options.jerk_ratio, 0, 2, sentence},
                  ratios);
  }
  return findings;
}

}  // namespace mien::motion
