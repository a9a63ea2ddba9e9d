#pragma once

#include <string>
#include <vector>

#include "pipeline/production/synthesis/repertoire.h"
#include "pipeline/production/synthesis/synthesis.h"

namespace mien::pipeline {

/// Returns warnings about a blend as plain sentences: about the examples with a weight in it, the
/// ratings, the blend itself, and sliding, penetration or floating of the feet in the result (only
/// the worst case per check and foot).
std::vector<std::string> blend_warnings(const Repertoire& repertoire, const Synthesis& synthesis);

}  // namespace mien::pipeline
