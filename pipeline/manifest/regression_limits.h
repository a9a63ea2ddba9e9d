#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/documents/concerns.h"

namespace mien::pipeline {

/// How far a stimulus may go from what was approved before it counts as another: `regression:` of a
/// manifest, or of one of its stimuli.
struct RegressionLimits {
  double position_mm = 1.0;       ///< of joints and points beside them, at any moment, in the world
  double turn_degrees = 0.1;      ///< of joints on their parents
  double speed_m_s = 0.05;        ///< of joints
  double contact_seconds = 0.05;  ///< that a foot comes down or leaves earlier or later
  double slide_mm = 1.0;          ///< that a standing foot slides farther
  bool findings = false;          ///< the lint may find errors that were not there
  double perceptual = 0.0;  ///< mean ꟻLIP of a key frame that differs by more than noise, 0 … 1
  double psnr_db = 0.1;     ///< that a video may be less like its frames
  std::vector<std::pair<std::string, double>> parts_mm;  ///< "left hand" → position_mm of its own

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
