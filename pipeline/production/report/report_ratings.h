#pragma once

#include <string>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/repertoire.h"

namespace mien::pipeline {

/// The part of report.html about the examples' ratings: which expected orders hold, and the mean
/// answers as a table. Empty without ratings.
std::string ratings_section(const Manifest& manifest, const Repertoire& repertoire);

}  // namespace mien::pipeline
