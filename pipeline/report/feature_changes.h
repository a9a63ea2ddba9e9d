#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/measures/motion_features.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/synthesis/motions.h"

namespace mien::pipeline {

/// One motion feature of a comparison's three motions, in the feature's unit.
struct FeatureChange {
  int feature = 0;  ///< index into motion_features()
  double reference = 0.0;
  double target = 0.0;
  double created = 0.0;

  double target_change() const { return target - reference; }
  double created_change() const { return created - reference; }
  /// Whether the target differs from the reference by more than can be measured of a capture: 1°,
  /// 1 cm, 0.05 m/s or 0.03 s.
  bool moved() const;
  /// Whether the created motion went the same way by at least a tenth of what the target did.
  bool agrees() const;
};

/// How a modified motion differs from its original, beside how an acted one does: the features that
/// all three motions of a comparison with a reference have. Empty for other sheets.
std::vector<FeatureChange> feature_changes(const Sheet& sheet, Motions& motions);

}  // namespace mien::pipeline
