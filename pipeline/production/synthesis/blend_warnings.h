#pragma once

#include <string>
#include <vector>

#include "pipeline/production/synthesis/repertoire.h"
#include "pipeline/production/synthesis/synthesis.h"

namespace mien::pipeline {

/// What somebody should know who blends examples; plain sentences: what was found odd about those
/// that have a share in the blend, about the ratings and about the blend, and of the feet of what
/// was made, how they slide, sink or float: of each check and foot the worst.
std::vector<std::string> blend_warnings(const Repertoire& repertoire, const Synthesis& synthesis);

}  // namespace mien::pipeline
