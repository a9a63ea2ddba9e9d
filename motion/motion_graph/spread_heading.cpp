#include "motion/motion_graph/spread_heading.h"

#include <algorithm>
#include <cmath>

namespace mien::motion {

namespace {

constexpr double most_added = 25.0 * radians_per_degree;
constexpr double fastest_added = 12.0 * radians_per_degree;  // a second

/// What is missing to a wish on the average over its time, radians.
double mean_missing(const WalkHeadings& headings, const HeadingWish& wish) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t f = 0; f < headings.seconds.size(); ++f) {
    const double before = wish.seconds - headings.seconds[f];
    const bool is_last = f + 1 == headings.seconds.size() && count == 0;
    if (!is_last && (before < 0.0 || before > wish.over_seconds)) continue;
    sum += std::remainder(wish.radians - headings.facings[f], 2.0 * pi);
    ++count;
  }
  return sum / count;
}

double risen(double share) {
  const double t = std::clamp(share, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace

SpreadHeading spread_heading(const WalkHeadings& headings, std::span<const HeadingWish> wishes) {
  SpreadHeading spread{std::vector<double>(headings.seconds.size(), 0.0), {}};
  double from = 0.0;
  double added = 0.0;
  for (const HeadingWish& wish : wishes) {
    // Done before the time over which the heading counts, where there is time before it.
    const double until = std::max(wish.seconds - wish.over_seconds, 0.5 * (from + wish.seconds));
    const double most = std::min(most_added, fastest_added * (until - from));
    const double missing = mean_missing(headings, wish) - added;
    const double more = std::clamp(missing, -most, most);
    for (std::size_t f = 0; f < spread.added.size(); ++f) {
      if (headings.seconds[f] < from) continue;
      spread.added[f] = added + more * risen((headings.seconds[f] - from) / (until - from));
    }
    spread.missing.push_back(missing - more);
    added += more;
    from = wish.seconds;
  }
  return spread;
}

}  // namespace mien::motion
