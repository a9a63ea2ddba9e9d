#pragma once

#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Targets, adjectives and features that are not there, a manifest without targets, or with a
/// questionnaire beside. The study's scales must have been read.
std::vector<Fault> check_matching(const Manifest& manifest);

}  // namespace mien::pipeline
