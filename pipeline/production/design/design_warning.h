#pragma once

#include <string>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// A warning about the design.
struct DesignWarning {
  std::string path;  ///< where it can be mended: "stimuli[0].factors.actor"
  std::string wrong;
  std::string remedy;
};

/// Returns where a factor first stands in the manifest: "stimuli[0].factors.actor", or the stimulus
/// from which it follows.
std::string path_of_factor(const Manifest& manifest, const std::string& factor);

}  // namespace mien::pipeline
