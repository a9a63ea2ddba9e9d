#pragma once

#include <vector>

#include "motion/measures/features/motion_features.h"

namespace mien::motion {

/// An angle of a segment over a cycle, forward and sideways, radians, without jumps at ±180°.
/// Frames at which an angle is undefined are omitted, so the two may differ in length.
struct SegmentAngles {
  std::vector<double> forward;
  std::vector<double> sideways;
};

/// The curves that motion features are statistics of (measure_features), 30 times a second.
/// Index 0 of the pairs is the left side.
struct FeatureCurves {
  SegmentAngles torso, head;
  std::array<SegmentAngles, 2> upper_arm, forearm, thigh, shin, foot;
  std::vector<double> mass_left, mass_height;                        ///< metres
  std::vector<double> velocity_forward, velocity_left, velocity_up;  ///< m/s
};

FeatureCurves feature_curves(const Example& example, const FeatureOptions& options);

}  // namespace mien::motion
