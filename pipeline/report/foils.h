#pragma once

#include <string>

#include "pipeline/synthesis/motions.h"

namespace mien::pipeline {

/// What of a motion a foil is certified in.
struct EmotionMeasures {
  double path_m = 0.0;      ///< way of head, wrists and ankles in the body's frame, mean, a cycle
  double duration_s = 0.0;  ///< of a cycle
  double unevenness = 0.0;  ///< SD of their speeds by the mean speed, mean: 0 at constant speed
};

EmotionMeasures measure_emotion(const motion::Clip& clip);

/// The difference of two postures, whatever is done with them: the largest angle, degrees, between
/// the mean rotations of a joint, of the pelvis without its heading.
double posture_difference(const motion::Clip& a, const motion::Clip& b);

/// The certificate of every foil (foils_form).
std::string foils_csv(const Manifest& manifest, Motions& motions);

}  // namespace mien::pipeline
