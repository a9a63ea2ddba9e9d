#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Names that a manifest's values may refer to.
struct Vocabulary {
  std::vector<std::string> parameters;  ///< groups and scales
  std::vector<std::string> features;    ///< groups and features
  std::vector<std::string> examples;
  std::vector<std::string> file_stems = {};  ///< of the motions in the examples' folder
  bool knows_examples = true;                ///< else there may be others
};

/// The examples of a manifest, the parameters that they have ratings on and the features, found
/// without reading a motion. Throws Error for what is wrong with the folder, the scales or the
/// answers, and for examples without an answer.
Vocabulary vocabulary_of(const Manifest& manifest);

/// What of that is certain where it throws: features, and the examples where their files are there.
Vocabulary certain_vocabulary(const Manifest& manifest);

}  // namespace mien::pipeline
