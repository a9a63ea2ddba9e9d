#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/documents/concerns.h"

namespace mien::pipeline {

/// The largest differences from the approved baseline at which a stimulus still counts as
/// unchanged: `regression:` of a manifest or of one of its stimuli.
struct RegressionLimits {
  /// Of joints and their virtual points in world space, at any time; millimetres.
  double position_mm = 1.0;
  double turn_degrees = 0.1;      ///< of joint rotations relative to their parents; degrees
  double speed_m_s = 0.05;        ///< of joint velocities; m/s
  double contact_seconds = 0.05;  ///< change of the time of a heel strike or toe off; seconds
  double slide_mm = 1.0;          ///< additional slide of a planted foot; millimetres
  bool findings = false;          ///< allow new lint errors
  double perceptual = 0.0;  ///< mean ꟻLIP of a key frame whose difference exceeds noise, 0 … 1
  double psnr_db = 0.1;     ///< loss of a video's PSNR against its frames; dB
  /// Body part → its own position_mm: "left hand".
  std::vector<std::pair<std::string, double>> parts_mm;

  friend bool operator==(const RegressionLimits&, const RegressionLimits&) = default;
};

void fields_of(auto&& field, MaybeConst<RegressionLimits> auto& limits) {
  field("position_mm", limits.position_mm, concerns::nothing);
  field("turn_degrees", limits.turn_degrees, concerns::nothing);
  field("speed_m_s", limits.speed_m_s, concerns::nothing);
  field("contact_seconds", limits.contact_seconds, concerns::nothing);
  field("slide_mm", limits.slide_mm, concerns::nothing);
  field("findings", limits.findings, concerns::nothing);
  field("perceptual", limits.perceptual, concerns::nothing);
  field("psnr_db", limits.psnr_db, concerns::nothing);
  field("parts_mm", limits.parts_mm, concerns::nothing);
}

}  // namespace mien::pipeline
