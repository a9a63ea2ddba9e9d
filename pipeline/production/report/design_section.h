#pragma once

#include <string>
#include <vector>

#include "pipeline/production/design/confounds.h"

namespace mien::pipeline {

/// The properties of the stimuli at each level of each factor, and which of them follow the factor
/// (confounds.h). Empty without factors.
std::string design_section(const std::vector<FactorProperty>& relations);

}  // namespace mien::pipeline
