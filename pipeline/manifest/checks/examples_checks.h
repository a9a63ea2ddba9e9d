#pragma once

#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Folders, ratings, scales and keytimes that are missing or do not go together.
std::vector<Fault> check_examples(const Manifest& manifest);

}  // namespace mien::pipeline
