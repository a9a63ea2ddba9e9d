#include "pipeline/production/design/design_findings.h"

#include <utility>

#include "pipeline/base/documents/places.h"

namespace mien::pipeline {

DesignFindings planned_design(const Manifest& manifest, Motions& motions) {
  if (studied_factors(manifest).empty()) return {};
  return {factor_properties(manifest, planned_properties(manifest, motions)),
          close_levels(manifest, motions)};
}

DesignFindings filmed_design(const Manifest& manifest, Motions& motions,
                             const std::filesystem::path& folder) {
  if (studied_factors(manifest).empty()) return {};
  return {factor_properties(manifest, filmed_properties(manifest, motions, folder)),
          close_levels(manifest, motions)};
}

std::vector<DesignWarning> design_warnings(const Manifest& manifest,
                                           const DesignFindings& findings) {
  std::vector<DesignWarning> warnings = confound_warnings(manifest, findings.properties);
  for (DesignWarning& warning : close_level_warnings(manifest, findings.close))
    warnings.push_back(std::move(warning));
  return warnings;
}

std::string to_sentence(const DesignWarning& warning) {
  return warning.wrong + "; " + warning.remedy;
}

Fault design_fault(const DesignWarning& warning, const Places& places) {
  return {place_of(places, warning.path), warning.path, warning.wrong, warning.remedy};
}

}  // namespace mien::pipeline
