#pragma once

#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Overlays and sheets whose parts do not go together.
std::vector<Fault> check_overlays(const Manifest& manifest);
std::vector<Fault> check_sheets(const Manifest& manifest);

}  // namespace mien::pipeline
