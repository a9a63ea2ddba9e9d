#include "motion/style_transfer/emotion_transform.h"

#include <algorithm>
#include <cmath>

#include "motion/error.h"

namespace mien::motion {

namespace {

/// Below this an amplitude (radians, metres) is stillness, and its ratio says nothing.
constexpr double stillness = 1e-4;
/// Below this a way along the floor is none, metres.
constexpr double least_travel = 0.1;

PeriodTransform transform_between(const PeriodMeasure& neutral, const PeriodMeasure& emotional) {
  PeriodTransform transform;
  transform.duration_ratio = emotional.seconds / neutral.seconds;
  for (int k = 0; k <= period_steps; ++k) {
    transform.timing.push_back(share_reaching(neutral.path, emotional.path[k]));
  }
  for (int c = 0; c < amplitude_classes; ++c) {
    if (neutral.amplitudes[c] < stillness) continue;
    transform.amplitude_ratios[c] = emotional.amplitudes[c] / neutral.amplitudes[c];
  }
  return transform;
}

/// `timing` taken over by `amount`, ascending from 0 to 1.
std::vector<double> partly(const std::vector<double>& timing, double amount) {
  std::vector<double> result = {0.0};
  for (size_t k = 1; k < timing.size(); ++k) {
    const double even = 1.0 / static_cast<double>(timing.size() - 1);
    const double step = (1.0 - amount) * even + amount * (timing[k] - timing[k - 1]);
    result.push_back(result.back() + std::max(0.0, step));
  }
  for (double& share : result) share /= result.back();
  return result;
}

/// One period of the motion and what becomes of it.
struct NewPeriod {
  int first = 0;
  int last = 0;
  double start = 0.0;  ///< in the result, frames
  double length = 0.0;
  std::vector<double> timing;
};

void scale_deviations(MotionCurves& curves, const NewPeriod& period,
                      const PeriodTransform& transform, double amount) {
  const MotionCurves before = curves;
  // Its end is the next one's beginning, and lies on both lines.
  for (int i = period.first; i < std::min(period.last, before.frame_count()); ++i) {
    const Eigen::RowVectorXd line =
        period_line(before, period.first, period.last, i - period.first);
    const Eigen::RowVectorXd deviation = before.values.row(i) - line;
    const auto put = [&](int column, int of_class) {
      curves.values.row(i).segment<3>(column) =
          line.segment<3>(column) +
          std::pow(transform.amplitude_ratios[of_class], amount) * deviation.segment<3>(column);
    };
    put(0, root_place_class);
    for (int joint = 0; joint < body_joint_count; ++joint) {
      put(first_curve(joint), amplitude_class(joint));
    }
  }
}

MotionCurves retimed(const MotionCurves& curves, const std::vector<NewPeriod>& periods) {
  const double total = periods.back().start + periods.back().length;
  const bool loops = curves.timing.loops;
  const int steps = std::max(4, static_cast<int>(std::lround(total)));
  const int frames = loops ? steps : steps + 1;
  const int source_steps = loops ? curves.frame_count() : curves.frame_count() - 1;
  MotionCurves result = curves;
  result.values.resize(frames, curve_count);
  size_t p = 0;
  for (int i = 0; i < frames; ++i) {
    const double time = i * (total / steps);
    while (p + 1 < periods.size() && time >= periods[p + 1].start) ++p;
    const NewPeriod& period = periods[p];
    const double share = at_share(period.timing, (time - period.start) / period.length);
    const double source = period.first + share * (period.last - period.first);
    result.values.row(i) = curves_at(curves, source / source_steps);
  }
  return result;
}

}  // namespace

EmotionTransform emotion_transform(const Clip& neutral, const Clip& emotional) {
  if (neutral.loops != emotional.loops) {
    throw Error("of \"" + neutral.name + "\" and \"" + emotional.name + "\" only one is cyclic",
                "take the emotion transform from two motions of one kind");
  }
  const BodyJoint effector = busiest_effector(neutral);
  const std::vector<PeriodMeasure> from = measured_periods(neutral, effector);
  const std::vector<PeriodMeasure> to = measured_periods(emotional, effector);
  EmotionTransform transform;
  transform.effector = effector;
  transform.mean = transform_between(mean_of(from), mean_of(to));
  for (size_t p = 0; from.size() == to.size() && p < from.size(); ++p) {
    transform.periods.push_back(transform_between(from[p], to[p]));
  }
  const double way = to_curves(neutral).way.norm();
  if (way > least_travel) transform.displacement_ratio = to_curves(emotional).way.norm() / way;
  return transform;
}

Clip transformed(const Clip& motion, const EmotionTransform& transform,
                 const EmotionTransformOptions& options) {
  MotionCurves curves = to_curves(motion);
  const std::vector<int> ends = basic_periods(motion, transform.effector);
  const bool period_by_period = transform.periods.size() == ends.size() - 1;
  std::vector<NewPeriod> periods;
  double start = 0.0;
  for (size_t p = 0; p + 1 < ends.size(); ++p) {
    const PeriodTransform& change = period_by_period ? transform.periods[p] : transform.mean;
    const double timing = options.timing ? options.amount : 0.0;
    NewPeriod period{ends[p], ends[p + 1], start, 0.0, partly(change.timing, timing)};
    period.length = (period.last - period.first) * std::pow(change.duration_ratio, timing);
    start += period.length;
    if (options.amplitude) scale_deviations(curves, period, change, options.amount);
    periods.push_back(std::move(period));
  }
  if (options.amplitude) curves.way *= std::pow(transform.displacement_ratio, options.amount);
  return to_clip(retimed(curves, periods));
}

Clip emotion_transformed(const Clip& motion, const Clip& neutral, const Clip& emotional,
                         const EmotionTransformOptions& options) {
  return transformed(motion, emotion_transform(neutral, emotional), options);
}

}  // namespace mien::motion
