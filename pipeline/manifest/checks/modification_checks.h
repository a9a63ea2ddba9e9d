#pragma once

#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/checks/vocabulary.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// What a schema cannot say of modifications: keys that exclude each other or belong to another
/// method, poses and styles that need examples or files where there are none.
std::vector<Fault> check_modifications(const Manifest& manifest);

/// Examples that modifications name and that do not exist.
std::vector<Fault> check_modification_names(const Manifest& manifest, const Vocabulary& vocabulary);

}  // namespace mien::pipeline
