#pragma once

#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/checks/vocabulary.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Ids and names of videos that occur twice.
std::vector<Fault> check_ids(const Manifest& manifest);

/// Adjectives, features, weights, modifications and sheets that name what does not exist.
std::vector<Fault> check_names(const Manifest& manifest, const Vocabulary& vocabulary);

}  // namespace mien::pipeline
