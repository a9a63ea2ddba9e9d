#pragma once

#include <vector>

#include "motion/measures/features/motion_features.h"

namespace mien::motion {

/// One motion feature of three motions, in the feature's unit, for comparing a created motion's
/// change from a reference with the target's change.
struct FeatureChange {
  int feature = 0;  ///< index into motion_features()
  double reference = 0.0;
  double target = 0.0;
  double created = 0.0;

  double target_change() const { return target - reference; }
  double created_change() const { return created - reference; }
  /// Whether the target differs from the reference by more than the measurement error of motion
  /// capture: 1°, 1 cm, 0.05 m/s or 0.03 s.
  bool moved() const;
  /// Whether the target moved, and the created motion changed in the same direction by at least a
  /// tenth of the target's change.
  bool agrees() const;
  /// Whether the target moved, and the created motion changed the other way by at least a tenth of
  /// the target's change.
  bool opposes() const;
};

/// The changes of the features that all three motions have, in the order of motion_features().
std::vector<FeatureChange> feature_changes(const FeatureValues& reference,
                                           const FeatureValues& target,
                                           const FeatureValues& created);

}  // namespace mien::motion
