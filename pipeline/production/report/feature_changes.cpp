#include "pipeline/production/report/feature_changes.h"

namespace mien::pipeline {

std::vector<motion::FeatureChange> feature_changes(const Sheet& sheet, Motions& motions) {
  if (!sheet.gallery.empty() || sheet.reference.empty()) return {};
  const auto values = [&](const std::string& name) {
    return motion::measure_features(motions.of(name).motion);
  };
  return motion::feature_changes(values(sheet.reference), values(sheet.target),
                                 values(sheet.created));
}

}  // namespace mien::pipeline
