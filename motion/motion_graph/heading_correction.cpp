#include "motion/motion_graph/heading_correction.h"

#include <algorithm>
#include <cmath>

namespace mien::motion {

namespace {

constexpr double most_added = 25.0 * radians_per_degree;
constexpr double fastest_added = 12.0 * radians_per_degree;  // a second

/// Mean heading error of a goal over its interval, radians.
double mean_missing(const WalkHeadings& headings, const HeadingGoal& goal) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t f = 0; f < headings.seconds.size(); ++f) {
    const double before = goal.seconds - headings.seconds[f];
    const bool is_last = f + 1 == headings.seconds.size() && count == 0;
    if (!is_last && (before < 0.0 || before > goal.over_seconds)) continue;
    sum += std::remainder(goal.radians - headings.facings[f], 2.0 * pi);
    ++count;
  }
  return sum / count;
}

}  // namespace

HeadingCorrection correct_headings(const WalkHeadings& headings,
                                   std::span<const HeadingGoal> goals) {
  HeadingCorrection correction{std::vector<double>(headings.seconds.size(), 0.0), {}};
  double from = 0.0;
  double added = 0.0;
  for (const HeadingGoal& goal : goals) {
    // Done before the time over which the heading counts, where there is time before it.
    const double until = std::max(goal.seconds - goal.over_seconds, 0.5 * (from + goal.seconds));
    const double most = std::min(most_added, fastest_added * (until - from));
    const double missing = mean_missing(headings, goal) - added;
    const double more = std::clamp(missing, -most, most);
    for (std::size_t f = 0; f < correction.added.size(); ++f) {
      if (headings.seconds[f] < from) continue;
      correction.added[f] =
          added + more * smooth_step((headings.seconds[f] - from) / (until - from));
    }
    correction.missing.push_back(missing - more);
    added += more;
    from = goal.seconds;
  }
  return correction;
}

}  // namespace mien::motion
