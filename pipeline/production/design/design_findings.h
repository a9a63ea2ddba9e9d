#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/production/design/close_levels.h"
#include "pipeline/production/design/confounds.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// What was found about the factors of a design, and about equalized durations.
struct DesignFindings {
  std::vector<FactorProperty> properties;
  std::vector<FactorLevels> close;
  std::optional<DesignWarning> cut = {};  ///< films that are cut by more than half
};

/// Returns the findings before films are rendered (planned_properties). Throws Error.
DesignFindings planned_design(const Manifest& manifest, Motions& motions);

/// Returns the findings about the films in the study's folder (filmed_properties). Throws Error.
DesignFindings filmed_design(const Manifest& manifest, Motions& motions,
                             const std::filesystem::path& folder);

/// Returns the warnings about confounds (confound_warnings), about levels that are alike
/// (close_level_warnings) and about films that equalizing durations cuts by more than half.
std::vector<DesignWarning> design_warnings(const Manifest& manifest,
                                           const DesignFindings& findings);

/// Returns what is wrong and how to mend it.
std::string to_sentence(const DesignWarning& warning);

/// Returns the warning as a fault with its position in the manifest.
Fault design_fault(const DesignWarning& warning, const Places& places);

}  // namespace mien::pipeline
