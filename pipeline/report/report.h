#pragma once

#include <string>

#include "pipeline/manifest/manifest.h"
#include "pipeline/report/methods.h"
#include "pipeline/synthesis/motions.h"

namespace mien::pipeline {

/// report.html: the whole study on one page that works from disk without a network. Videos, contact
/// sheets and comparison sheets are linked by paths relative to the study's folder; style is
/// inline.
std::string report(const Manifest& manifest, Motions& motions, const Methods& methods);

}  // namespace mien::pipeline
