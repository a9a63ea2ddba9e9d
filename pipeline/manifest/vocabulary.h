#pragma once

#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/manifest_checks.h"

namespace mien::pipeline {

/// The examples of a manifest, the parameters that they have ratings on and the features, found
/// without reading a motion. Throws Error for what is wrong with the folder, the scales or the
/// answers.
Vocabulary vocabulary_of(const Manifest& manifest);

}  // namespace mien::pipeline
