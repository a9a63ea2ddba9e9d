#pragma once

#include <array>
#include <vector>

#include "motion/style_transfer/basic_periods.h"

namespace mien::motion {

struct EmotionTransformOptions {
  double amount = 1.0;    ///< 0: motion unchanged; 1: the emotion as captured; above 1: exaggerated
  bool timing = true;     ///< whether to apply the emotional timing
  bool amplitude = true;  ///< whether to apply the emotional amplitudes and travel
};

/// Transform of one basic period of a motion.
struct PeriodTransform {
  double duration_ratio = 1.0;
  /// Normalized time in the neutral period at equal steps of normalized time in the emotional one,
  /// ascending 0 … 1.
  std::vector<double> timing;
  std::array<double, amplitude_classes> amplitude_ratios = {1, 1, 1, 1, 1};
};

/// Emotion transform: the differences in timing and amplitude between an emotional and a neutral
/// performance of the same action (Amaya, Bruderlin and Calvert 1996).
struct EmotionTransform {
  BodyJoint effector = RightWrist;       ///< end effector whose path defines timing and periods
  std::vector<PeriodTransform> periods;  ///< one per period if both motions have the same number;
                                         ///< else empty, with `mean` only
  PeriodTransform mean;
  double displacement_ratio = 1.0;  ///< ratio of the horizontal travel, emotional to neutral
};

/// Fits the transform. In a clip that does not loop, a period ends where the end effector (the
/// wrist or ankle with the longest path relative to the pelvis) returns towards its starting
/// position; a loop is one period. Timing is the share of the end effector's path covered as a
/// function of time. Amplitude is a joint's deviation from the straight line between the period's
/// ends (in a loop, from its mean); the emotional-to-neutral ratio is taken per class of joints.
/// Throws Error if only one of the clips loops.
EmotionTransform emotion_transform(const Clip& neutral, const Clip& emotional);

/// Applies the transform to a motion: first scales the deviations, then warps time. Ratios are
/// raised to the power `amount`; timing is interpolated between even (0) and the transform's (1),
/// and stays ascending. Mean postures are not transferred. Foot plants are not restored.
Clip transformed(const Clip& motion, const EmotionTransform& transform,
                 const EmotionTransformOptions& options = {});

/// Calls emotion_transform and transformed.
Clip emotion_transformed(const Clip& motion, const Clip& neutral, const Clip& emotional,
                         const EmotionTransformOptions& options = {});

}  // namespace mien::motion
