#pragma once

#include <array>
#include <vector>

#include "motion/style_transfer/motion_curves.h"

namespace mien::motion {

/// The wrist or ankle with the longest path about the pelvis.
BodyJoint busiest_effector(const Clip& clip);

/// Where basic periods begin and end, frames: first 0; last the frame after the last of a loop,
/// the last of a take. In a take a period ends where the effector, having been away from its first
/// place, has come nearest to it again; both ways are at least a quarter of the farthest.
std::vector<int> basic_periods(const Clip& clip, BodyJoint effector);

/// Joints by distance from the body's centre: trunk; neck, head and the limbs' roots; elbows and
/// knees; hands and feet. The root's position is a separate class.
inline constexpr int amplitude_classes = 5;
inline constexpr int root_place_class = 4;
int amplitude_class(int joint);

/// Even steps of a period's time and path at which it is measured.
inline constexpr int period_steps = 100;

/// What the emotion transform measures in a basic period.
struct PeriodMeasure {
  double seconds = 0.0;
  /// Share of the effector's path behind it at even shares of the time, 0 … 1, ascending.
  std::vector<double> path = std::vector<double>(period_steps + 1);
  /// Root mean square deviation from the line between the period's ends (a loop: from the mean), at
  /// even shares of the path, summed over the joints of each class; radians, of the place metres.
  std::array<double, amplitude_classes> amplitudes = {};
};

/// Measures every period of the clip.
std::vector<PeriodMeasure> measured_periods(const Clip& clip, BodyJoint effector);

PeriodMeasure mean_of(const std::vector<PeriodMeasure>& periods);

/// The line that deviations of a period of the curves are taken from, at frame `first` + `offset`:
/// between the values at the ends, or the mean of a loop.
Eigen::RowVectorXd period_line(const MotionCurves& curves, int first, int last, double offset);

/// Where an ascending function given at even steps of [0, 1] reaches `value`, as a share.
double share_reaching(const std::vector<double>& ascending, double value);

/// A function given at even steps of [0, 1], linearly between them.
double at_share(const std::vector<double>& even, double share);

}  // namespace mien::motion
