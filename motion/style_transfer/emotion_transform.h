#pragma once

#include <array>
#include <vector>

#include "motion/style_transfer/basic_periods.h"

namespace mien::motion {

struct EmotionTransformOptions {
  double amount = 1.0;    ///< 0 leaves the motion, 1 is the emotion as captured, more exaggerates
  bool timing = true;     ///< take over the emotion's timing
  bool amplitude = true;  ///< take over how far the joints swing
};

/// Transform of one basic period of a motion.
struct PeriodTransform {
  double duration_ratio = 1.0;
  /// Share of the neutral period's time at even shares of the emotional one's, ascending 0 … 1.
  std::vector<double> timing;
  std::array<double, amplitude_classes> amplitude_ratios = {1, 1, 1, 1, 1};
};

/// Emotion transform: timing and amplitude by which an emotional performance differs from a
/// neutral one of the same action (Amaya, Bruderlin and Calvert 1996).
struct EmotionTransform {
  BodyJoint effector = RightWrist;       ///< whose path defines timing and periods
  std::vector<PeriodTransform> periods;  ///< one for each period of both, else only the mean
  PeriodTransform mean;
  double displacement_ratio = 1.0;  ///< of the ways along the floor
};

/// Periods of a take end where the end effector (the wrist or ankle with the longest path about
/// the pelvis) comes back towards where it started; a loop is one period. Timing: how far along its
/// path in the period the end effector is at each moment. Amplitude: deviation of the joint from
/// the straight line between the period's ends (in a loop, which has none, from its mean), ratio of
/// emotional to neutral within each class of joints. Both must loop or neither; throws Error
/// otherwise.
EmotionTransform emotion_transform(const Clip& neutral, const Clip& emotional);

/// The motion with the transform: deviations scaled, then time. Ratios to the power `amount`;
/// timing stays ascending. Mean posture is not changed: the method has no means for it. Feet are
/// not repaired.
Clip transformed(const Clip& motion, const EmotionTransform& transform,
                 const EmotionTransformOptions& options = {});

/// emotion_transform and transformed in one call.
Clip emotion_transformed(const Clip& motion, const Clip& neutral, const Clip& emotional,
                         const EmotionTransformOptions& options = {});

}  // namespace mien::motion
