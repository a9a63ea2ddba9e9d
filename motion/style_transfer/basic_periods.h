#pragma once

#include <array>
#include <vector>

#include "motion/style_transfer/motion_curves.h"

namespace mien::motion {

/// The end effector (wrist or ankle) with the longest path relative to the pelvis.
BodyJoint busiest_effector(const Clip& clip);

/// Boundaries of the basic periods, frames. The first is 0; the last is the frame count of a loop,
/// or the last frame of any other clip. In a clip that does not loop, a period ends where the
/// effector, after moving away from its starting position, is nearest to it again; it must move
/// away and return by at least a quarter of its largest distance.
std::vector<int> basic_periods(const Clip& clip, BodyJoint effector);

/// Classes of joints whose amplitudes are measured together, by distance from the body's centre:
/// trunk; neck, head and the limbs' roots; elbows and knees; hands and feet. The root's position
/// forms a fifth class.
inline constexpr int amplitude_classes = 5;
inline constexpr int root_place_class = 4;
int amplitude_class(int joint);

/// Number of equal steps at which a period is measured, both in time and along the path.
inline constexpr int period_steps = 100;

/// Measurements of a basic period for the emotion transform.
struct PeriodMeasure {
  double seconds = 0.0;
  /// Share of the effector's path covered at equal steps of time, 0 … 1, ascending.
  std::vector<double> path = std::vector<double>(period_steps + 1);
  /// Root mean square deviation from the line between the period's ends (for a loop, from the
  /// mean), at equal steps of the path, summed over the joints of each class; radians (root
  /// position: metres).
  std::array<double, amplitude_classes> amplitudes = {};
};

/// Measures every period of the clip.
std::vector<PeriodMeasure> measured_periods(const Clip& clip, BodyJoint effector);

PeriodMeasure mean_of(const std::vector<PeriodMeasure>& periods);

/// The reference value from which deviations in a period are measured, at frame `first` + `offset`:
/// on the straight line between the values at the period's ends, or the mean of a loop.
Eigen::RowVectorXd period_line(const MotionCurves& curves, int first, int last, double offset);

/// The argument in [0, 1] at which an ascending function, sampled at equal steps of [0, 1], reaches
/// `value`.
double share_reaching(const std::vector<double>& ascending, double value);

/// The value at `share` of a function sampled at equal steps of [0, 1], by linear interpolation.
double at_share(const std::vector<double>& even, double share);

}  // namespace mien::motion
