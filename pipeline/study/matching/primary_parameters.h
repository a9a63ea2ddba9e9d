#pragma once

#include <string>
#include <vector>

#include "pipeline/production/synthesis/repertoire.h"

namespace mien::pipeline {

/// The parameters that participants of a matching experiment would move: groups of rated scales
/// or, where there are none, all rated scales.
std::vector<std::string> primary_adjectives(const Repertoire& repertoire);

/// The four groups of features.
std::vector<std::string> primary_features();

}  // namespace mien::pipeline
