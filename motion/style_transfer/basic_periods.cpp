#include "motion/style_transfer/basic_periods.h"

#include <algorithm>
#include <cmath>

#include "motion/math/filter.h"

namespace mien::motion {

namespace {

/// A standing effector counts as moving at this share of its mean speed, so that time goes on.
constexpr double creeping = 1e-3;
/// Path that an effector at rest is taken to go, metres.
constexpr double least_path = 1e-6;
/// A way there or back that counts, as a share of the farthest.
constexpr double least_travel_m = 0.25;

/// About the pelvis, axes of the world, without marker noise.
std::vector<Vec3> effector_path(const Clip& clip, BodyJoint effector) {
  std::vector<Vec3> path;
  for (const std::vector<Vec3>& joints : joint_paths(clip)) {
    path.push_back(joints[effector] - joints[Pelvis]);
  }
  return low_pass(path, gait_cutoff_hz(clip.frames_per_second), clip.frames_per_second,
                  clip.loops ? SignalEnds::periodic : SignalEnds::open);
}

/// Path behind the effector at each frame; of a loop also at the frame after the last. Metres.
std::vector<double> arc_length(const Clip& clip, BodyJoint effector) {
  std::vector<Vec3> path = effector_path(clip, effector);
  if (clip.loops) path.push_back(path.front());
  std::vector<double> length(path.size(), 0.0);
  for (size_t i = 1; i < path.size(); ++i) {
    length[i] = length[i - 1] + (path[i] - path[i - 1]).norm();
  }
  const double creep =
      std::max(creeping * length.back(), least_path) / static_cast<double>(length.size() - 1);
  for (size_t i = 0; i < length.size(); ++i) length[i] += creep * static_cast<double>(i);
  return length;
}

int last_frame(const Clip& clip) {
  return clip.loops ? clip.frame_count() : clip.frame_count() - 1;
}

Eigen::RowVectorXd at_frame(const MotionCurves& curves, double frame) {
  return curves_at(curves,
                   frame / (curves.timing.loops ? curves.frame_count() : curves.frame_count() - 1));
}

void measure_amplitudes(const MotionCurves& curves, int first, int last, PeriodMeasure& measure) {
  Eigen::RowVectorXd squares = Eigen::RowVectorXd::Zero(curve_count);
  for (int k = 0; k <= period_steps; ++k) {
    const double share = share_reaching(measure.path, static_cast<double>(k) / period_steps);
    const double offset = share * (last - first);
    const Eigen::RowVectorXd deviation =
        at_frame(curves, first + offset) - period_line(curves, first, last, offset);
    squares += deviation.cwiseAbs2() / (period_steps + 1);
  }
  measure.amplitudes[root_place_class] += std::sqrt(squares.segment<3>(0).sum());
  for (int joint = 0; joint < body_joint_count; ++joint) {
    measure.amplitudes[amplitude_class(joint)] +=
        std::sqrt(squares.segment<3>(first_curve(joint)).sum());
  }
}

}  // namespace

BodyJoint busiest_effector(const Clip& clip) {
  BodyJoint busiest = RightWrist;
  double longest = -1.0;
  for (const BodyJoint effector : {RightWrist, LeftWrist, RightAnkle, LeftAnkle}) {
    const double length = arc_length(clip, effector).back();
    // Left and right of an even walk are equally busy: rounding must not decide.
    if (length <= 1.001 * longest) continue;
    longest = length;
    busiest = effector;
  }
  return busiest;
}

std::vector<int> basic_periods(const Clip& clip, BodyJoint effector) {
  std::vector<int> periods = {0};
  if (!clip.loops) {
    const std::vector<Vec3> path = effector_path(clip, effector);
    std::vector<double> away;
    for (const Vec3& place : path) away.push_back((place - path.front()).norm());
    const double way = least_travel_m * *std::max_element(away.begin(), away.end());
    bool returning = false;
    size_t turn = 0;  // farthest since the last boundary, or nearest since then
    for (size_t i = 1; i < away.size(); ++i) {
      if (returning ? away[i] < away[turn] : away[i] > away[turn]) turn = i;
      if (std::abs(away[i] - away[turn]) <= way) continue;
      if (returning) periods.push_back(static_cast<int>(turn));
      returning = !returning;
      turn = i;
    }
  }
  periods.push_back(last_frame(clip));
  return periods;
}

int amplitude_class(int joint) {
  const auto is_one_of = [&](auto... joints) { return ((joint == joints) || ...); };
  if (is_one_of(Pelvis, Spine, Chest)) return 0;
  if (is_one_of(LeftElbow, RightElbow, LeftKnee, RightKnee)) return 2;
  return is_one_of(LeftWrist, RightWrist, LeftAnkle, RightAnkle, LeftToe, RightToe) ? 3 : 1;
}

std::vector<PeriodMeasure> measured_periods(const Clip& clip, BodyJoint effector) {
  const std::vector<int> periods = basic_periods(clip, effector);
  const std::vector<double> length = arc_length(clip, effector);
  const MotionCurves curves = to_curves(clip);
  std::vector<PeriodMeasure> measures;
  for (size_t p = 0; p + 1 < periods.size(); ++p) {
    const int first = periods[p];
    const int last = periods[p + 1];
    PeriodMeasure measure;
    measure.seconds = (last - first) / clip.frames_per_second;
    for (int k = 0; k <= period_steps; ++k) {
      const double frame = first + static_cast<double>(k) / period_steps * (last - first);
      const int whole = std::min(static_cast<int>(frame), last - 1);
      const double here = length[whole] + (frame - whole) * (length[whole + 1] - length[whole]);
      measure.path[k] = (here - length[first]) / (length[last] - length[first]);
    }
    measure_amplitudes(curves, first, last, measure);
    measures.push_back(std::move(measure));
  }
  return measures;
}

PeriodMeasure mean_of(const std::vector<PeriodMeasure>& periods) {
  PeriodMeasure mean;
  const double share = 1.0 / static_cast<double>(periods.size());
  for (const PeriodMeasure& period : periods) {
    mean.seconds += share * period.seconds;
    for (int k = 0; k <= period_steps; ++k) mean.path[k] += share * period.path[k];
    for (int c = 0; c < amplitude_classes; ++c) mean.amplitudes[c] += share * period.amplitudes[c];
  }
  return mean;
}

Eigen::RowVectorXd period_line(const MotionCurves& curves, int first, int last, double offset) {
  if (curves.timing.loops) return curves.values.colwise().mean();
  return curves.values.row(first) +
         offset / (last - first) * (curves.values.row(last) - curves.values.row(first));
}

double share_reaching(const std::vector<double>& ascending, double value) {
  if (value <= ascending.front()) return 0.0;
  if (value >= ascending.back()) return 1.0;
  const auto after = std::upper_bound(ascending.begin(), ascending.end(), value);
  const auto k = static_cast<double>(after - ascending.begin()) - 1.0;
  const double below = *(after - 1);
  return (k + (value - below) / (*after - below)) / static_cast<double>(ascending.size() - 1);
}

double at_share(const std::vector<double>& even, double share) {
  const double steps = static_cast<double>(even.size() - 1);
  const double place = std::clamp(share, 0.0, 1.0) * steps;
  const auto k = std::min(static_cast<size_t>(place), even.size() - 2);
  return even[k] + (place - static_cast<double>(k)) * (even[k + 1] - even[k]);
}

}  // namespace mien::motion
