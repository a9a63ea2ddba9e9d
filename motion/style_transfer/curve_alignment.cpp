#include "motion/style_transfer/curve_alignment.h"

#include "motion/math/filter.h"

namespace mien::motion {

namespace {

/// Styles change tempo no faster than this.
constexpr double timing_cutoff_hz = 4.0;

}  // namespace

Eigen::MatrixXd with_closing_frame(const MotionCurves& curves) {
  if (!curves.timing.loops) return curves.values;
  Eigen::MatrixXd closed(curves.frame_count() + 1, curve_count);
  closed << curves.values, curves.values.row(0);
  return closed;
}

double frame_span(const MotionCurves& curves) {
  return curves.timing.loops ? curves.frame_count() : curves.frame_count() - 1;
}

std::vector<double> smoothed_times(const std::vector<double>& times, const MotionCurves& from,
                                   const MotionCurves& to) {
  const double even = frame_span(to) / frame_span(from);
  std::vector<double> ahead;
  for (int i = 0; i < from.frame_count(); ++i) ahead.push_back(times[i] - even * i);
  ahead = low_pass(ahead, timing_cutoff_hz, from.timing.frames_per_second,
                   from.timing.loops ? SignalEnds::periodic : SignalEnds::open);
  for (size_t i = 0; i < ahead.size(); ++i) ahead[i] += even * static_cast<double>(i);
  return ahead;
}

}  // namespace mien::motion
