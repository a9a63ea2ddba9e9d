#pragma once

#include <string>
#include <vector>

#include "pipeline/documents/fault.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// What a schema cannot say: ids that occur twice, files that are missing, sizes that no encoder
/// takes, values that need examples or ratings where there are none, sheets of one motion.
std::vector<Fault> check_meaning(const Manifest& manifest);

/// Names that a manifest's values may refer to.
struct Vocabulary {
  std::vector<std::string> parameters;  ///< groups and scales
  std::vector<std::string> features;    ///< groups and features
  std::vector<std::string> examples;
};

/// Adjectives, features, weights and sheets that name what does not exist.
std::vector<Fault> check_names(const Manifest& manifest, const Vocabulary& vocabulary);

}  // namespace mien::pipeline
