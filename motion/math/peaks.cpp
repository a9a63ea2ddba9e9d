#include "motion/math/peaks.h"

#include <algorithm>
#include <limits>

namespace mien::motion {

namespace {

constexpr double no_base = -std::numeric_limits<double>::infinity();

/// Lowest value between sample `peak` and the next higher one in direction `step`; `no_base` when
/// the end comes first and lies within `margin`.
double base(std::span<const double> signal, long peak, long step, double margin) {
  const auto count = static_cast<long>(signal.size());
  const double height = signal[static_cast<size_t>(peak)];
  double lowest = height;
  long i = peak + step;
  for (; i >= 0 && i < count && signal[static_cast<size_t>(i)] <= height; i += step) {
    lowest = std::min(lowest, signal[static_cast<size_t>(i)]);
  }
  const bool at_end = i < 0 || i >= count;
  const auto distance = static_cast<double>((step > 0 ? i - peak : peak - i) - 1);
  return at_end && distance <= margin ? no_base : lowest;
}

Peak refined(std::span<const double> signal, size_t i, double prominence) {
  const double before = signal[i - 1];
  const double here = signal[i];
  const double after = signal[i + 1];
  const double bend = before - 2.0 * here + after;
  const double shift = bend < 0.0 ? 0.5 * (before - after) / bend : 0.0;
  return {static_cast<double>(i) + std::clamp(shift, -0.5, 0.5), here, prominence};
}

}  // namespace

std::vector<Peak> prominent_peaks(std::span<const double> signal, double prominence,
                                  double margin) {
  std::vector<Peak> peaks;
  for (size_t i = 1; i + 1 < signal.size(); ++i) {
    // A plateau counts at its first sample.
    if (signal[i] <= signal[i - 1] || signal[i] < signal[i + 1]) continue;
    const auto at = static_cast<long>(i);
    const double left = base(signal, at, -1, margin);
    const double right = base(signal, at, 1, margin);
    if (left == no_base && right == no_base) continue;
    const double rise = signal[i] - std::max(left, right);
    if (rise >= prominence) peaks.push_back(refined(signal, i, rise));
  }
  return peaks;
}

}  // namespace mien::motion
