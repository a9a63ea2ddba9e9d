#pragma once

#include <string>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// The part of report.html about the recordings: their licences and sources, as far as the manifest
/// states them, and for each recording of points how well the body fits it: per point, over time,
/// and which points were filled and for how long. Empty if there is neither.
std::string recordings_section(const Manifest& manifest, Motions& motions);

}  // namespace mien::pipeline
