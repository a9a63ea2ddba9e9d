#pragma once

#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Stimuli whose values need examples or ratings where there are none, clips that are missing, and
/// options of another method of interpolation.
std::vector<Fault> check_stimuli(const Manifest& manifest);

}  // namespace mien::pipeline
