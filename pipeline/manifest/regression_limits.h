#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/documents/concerns.h"

namespace mien::pipeline {

/// The largest differences from the approved baseline at which a stimulus still counts as
/// unchanged: `regression:` of a manifest or of one of its stimuli.
struct RegressionLimits {
  /// Displacement of a joint, or of a point 0.1 m off its bone, at any time, in world space;
  /// millimetres.
  double position_mm = 1.0;
  double turn_degrees = 0.1;  ///< rotation of a joint relative to its parent; degrees
  double speed_m_s = 0.05;    ///< velocity of a joint; m/s
  /// Change in the time of a heel strike or toe off, or duration of a contact that is new or gone;
  /// seconds.
  double contact_seconds = 0.05;
  double slide_mm = 1.0;  ///< additional slide of a planted foot; millimetres
  bool findings = false;  ///< allow new lint errors
  /// Mean ꟻLIP of a key frame, 0 … 1. Differences within rendering noise are always tolerated.
  double perceptual = 0.0;
  double psnr_db = 0.1;  ///< decrease of a video's lowest PSNR relative to its frame files; dB
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
