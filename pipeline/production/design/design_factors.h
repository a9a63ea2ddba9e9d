#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// A warning about the design.
struct DesignWarning {
  std::string path;  ///< where it can be mended: "stimuli[0].factors.actor"
  std::string wrong;
  std::string remedy;
};

/// Returns the factors that a design is checked by: those that any stimulus states, and `emotion`.
/// Others that follow from how stimuli are made (levels_of) describe single motions.
std::vector<std::string> design_factors(const Manifest& manifest);

/// Whether any stimulus states the factor.
bool is_stated(const Manifest& manifest, const std::string& factor);

/// Returns where a factor first stands in the manifest: "stimuli[0].factors.actor", or the stimulus
/// from which it follows.
std::string path_of_factor(const Manifest& manifest, const std::string& factor);

}  // namespace mien::pipeline
