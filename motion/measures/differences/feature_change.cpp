#include "motion/measures/differences/feature_change.h"

#include <cmath>
#include <cstddef>
#include <iterator>

namespace mien::motion {

namespace {

constexpr double least_share = 0.1;

/// By unit: degrees, metres, metres per second, seconds.
constexpr double measurable[] = {1.0, 0.01, 0.05, 0.03};
static_assert(std::size(measurable) == static_cast<std::size_t>(FeatureUnit::seconds) + 1);

}  // namespace

bool FeatureChange::moved() const {
  const MotionFeature& what = motion_features()[static_cast<std::size_t>(feature)];
  return std::abs(target_change()) > measurable[static_cast<std::size_t>(what.unit)];
}

bool FeatureChange::agrees() const {
  return moved() && created_change() / target_change() >= least_share;
}

bool FeatureChange::opposes() const {
  return moved() && created_change() / target_change() <= -least_share;
}

std::vector<FeatureChange> feature_changes(const FeatureValues& reference,
                                           const FeatureValues& target,
                                           const FeatureValues& created) {
  std::vector<FeatureChange> changes;
  for (size_t i = 0; i < reference.size(); ++i) {
    if (!std::isfinite(reference[i] + target[i] + created[i])) continue;
    changes.push_back({static_cast<int>(i), reference[i], target[i], created[i]});
  }
  return changes;
}

}  // namespace mien::motion
