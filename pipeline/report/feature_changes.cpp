#include "pipeline/report/feature_changes.h"

#include <cmath>

namespace mien::pipeline {

namespace {

constexpr double least_share = 0.1;

double measurable(motion::FeatureUnit unit) {
  switch (unit) {
    case motion::FeatureUnit::degrees:
      return 1.0;
    case motion::FeatureUnit::metres:
      return 0.01;
    case motion::FeatureUnit::metres_per_second:
      return 0.05;
    case motion::FeatureUnit::seconds:
      break;
  }
  return 0.03;
}

}  // namespace

bool FeatureChange::moved() const {
  const motion::MotionFeature& what = motion::motion_features()[static_cast<std::size_t>(feature)];
  return std::abs(target_change()) > measurable(what.unit);
}

bool FeatureChange::agrees() const {
  return moved() && created_change() / target_change() >= least_share;
}

std::vector<FeatureChange> feature_changes(const Sheet& sheet, Motions& motions) {
  std::vector<FeatureChange> changes;
  if (!sheet.gallery.empty() || sheet.reference.empty()) return changes;
  const auto values = [&](const std::string& name) {
    return motion::measure_features(motions.of(name).motion);
  };
  const motion::FeatureValues reference = values(sheet.reference);
  const motion::FeatureValues target = values(sheet.target);
  const motion::FeatureValues created = values(sheet.created);
  for (std::size_t i = 0; i < reference.size(); ++i) {
    if (!std::isfinite(reference[i] + target[i] + created[i])) continue;
    changes.push_back({static_cast<int>(i), reference[i], target[i], created[i]});
  }
  return changes;
}

}  // namespace mien::pipeline
