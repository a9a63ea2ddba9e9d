#pragma once

#include <vector>

#include "motion/style_transfer/motion_curves.h"

namespace mien::motion {

/// Values with the first frame once more at the end of a loop, so that both ends of two loops
/// correspond.
Eigen::MatrixXd with_closing_frame(const MotionCurves& curves);

/// Frames from the first to the last, of a loop to the one after the last.
double frame_span(const MotionCurves& curves);

/// Corresponding frames of `to` at each frame of `from`, found by dynamic programming in whole and
/// half frames, as a smooth course of time: what they are ahead of an even one, below 4 Hz.
std::vector<double> smoothed_times(const std::vector<double>& times, const MotionCurves& from,
                                   const MotionCurves& to);

}  // namespace mien::motion
