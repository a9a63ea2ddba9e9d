#pragma once

#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Reads the texts that the matching experiment names by their files. Faults: what cannot be read.
std::vector<Fault> complete_matching(Manifest& manifest);

/// Targets, adjectives and features that are not there, a manifest without targets, or with a
/// questionnaire beside. The study's scales must have been read.
std::vector<Fault> check_matching(const Manifest& manifest);

}  // namespace mien::pipeline
