#pragma once

#include <span>
#include <string>
#include <vector>

#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// The measures by which a foil is certified.
struct EmotionMeasures {
  /// Path length of head, wrists and ankles relative to the body, mean over these; in one cycle, or
  /// in the whole of a motion that does not loop.
  double path_m = 0.0;
  double duration_s = 0.0;  ///< duration of the cycle, or of a motion that does not loop
  /// Coefficient of variation of the speeds of head, wrists and ankles, mean over these; 0 at
  /// constant speed.
  double unevenness = 0.0;
};

EmotionMeasures measure_emotion(const motion::Clip& clip);

/// Returns the difference between the mean postures of two clips: of all joints, the largest angle,
/// in degrees, between the joint's mean rotations in the two clips. The heading of the pelvis is
/// ignored.
double posture_difference(const motion::Clip& a, const motion::Clip& b);

/// One aspect of a foil and of its original motion.
struct CertifiedAspect {
  FoilAspect aspect;
  const char* measure;  ///< description of the measure, with its unit
  double of_value;      ///< value of the original motion; NaN if only the difference is known
  double foil_value;
  double difference;  ///< degrees for posture, otherwise relative
  double tolerance;

  bool is_held() const;  ///< the absolute difference is below the tolerance
};

/// All aspects of a foil, measured on the finished motions of the foil and of its original.
struct Certificate {
  std::string id;
  Foil foil;
  std::vector<CertifiedAspect> aspects;
};

/// Returns the certificates of all foils among the stimuli.
std::vector<Certificate> foil_certificates(std::span<const Stimulus> stimuli, Motions& motions);

}  // namespace mien::pipeline
