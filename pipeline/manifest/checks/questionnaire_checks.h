#pragma once

#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Stimuli, scales and factors that are not there, and settings that exclude each other. The
/// study's scales must have been read.
std::vector<Fault> check_questionnaire(const Manifest& manifest);

}  // namespace mien::pipeline
