#pragma once

#include <span>
#include <string>
#include <vector>

#include "pipeline/production/synthesis/motions.h"

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

/// One aspect of a foil and of the motion that it is of.
struct CertifiedAspect {
  FoilAspect aspect;
  const char* measure;  ///< what was measured, with its unit
  double of_value;      ///< NaN: only the difference is known
  double foil_value;
  double difference;  ///< degrees of posture, else a share
  double tolerance;

  bool is_held() const;
};

/// All aspects of a foil, measured of both finished motions.
struct Certificate {
  std::string id;
  Foil foil;
  std::vector<CertifiedAspect> aspects;
};

/// The certificates of every foil among some of a study's stimuli.
std::vector<Certificate> foil_certificates(std::span<const Stimulus> stimuli, Motions& motions);

}  // namespace mien::pipeline
