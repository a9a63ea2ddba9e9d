#include "pipeline/production/synthesis/blend_warnings.h"

#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace mien::pipeline {

namespace {

/// Whether it is about an example without a share in the blend: what is found odd about an example
/// begins with its name, or with that of its file.
bool is_of_unused(const std::string& warning, const Repertoire& repertoire,
                  const Synthesis& synthesis) {
  for (std::size_t i = 0; i < repertoire.origins.size(); ++i) {
    const std::string file = repertoire.origins[i].file.filename().string();
    const bool is_named =
        warning.starts_with(repertoire.names[i].name + ": ") || warning.starts_with(file + ": ");
    const auto weight = static_cast<Eigen::Index>(i);
    if (is_named) return weight < synthesis.weights.size() && synthesis.weights[weight] == 0.0;
  }
  return false;
}

std::vector<std::string> warnings_of_feet(const Synthesis& synthesis) {
  std::map<std::pair<std::string, std::string>, const motion::Finding*> worst;
  for (const motion::Finding& finding : synthesis.findings) {
    if (finding.check != "foot-skate" && finding.check != "drift" &&
        finding.check != "penetration" && finding.check != "floating") {
      continue;
    }
    const motion::Finding*& known = worst[{finding.check, finding.joint}];
    if (!known || std::abs(finding.measured) > std::abs(known->measured)) known = &finding;
  }
  std::vector<std::string> warnings;
  for (const auto& [place, finding] : worst) {
    warnings.push_back(fmt::format("{} ({}, frames {}–{})", finding->sentence, finding->check,
                                   finding->first, finding->last));
  }
  return warnings;
}

}  // namespace

std::vector<std::string> blend_warnings(const Repertoire& repertoire, const Synthesis& synthesis) {
  std::vector<std::string> warnings;
  for (const std::string& warning : repertoire.warnings) {
    if (!is_of_unused(warning, repertoire, synthesis)) warnings.push_back(warning);
  }
  for (const auto& more : {synthesis.warnings, warnings_of_feet(synthesis)})
    warnings.insert(warnings.end(), more.begin(), more.end());
  return warnings;
}

}  // namespace mien::pipeline
