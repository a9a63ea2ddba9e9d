#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Names that a manifest's values may refer to.
struct Vocabulary {
  std::vector<std::string> parameters;  ///< rated groups of scales, then rated scales
  std::vector<std::string> features;    ///< groups of features, then features
  std::vector<std::string> examples;
  std::vector<std::string> file_stems = {};  ///< file stems of the motions in the examples' folder
  bool knows_examples = true;                ///< false: the list of examples may be incomplete
};

/// Returns the examples of a manifest, the rated parameters and the features, without reading a
/// motion. Throws Error for faults of the folder, the scales or the answers, and for examples
/// without an answer.
Vocabulary vocabulary_of(const Manifest& manifest);

/// Returns the part that is still known when `vocabulary_of` throws: the features, and the examples
/// if their files exist.
Vocabulary certain_vocabulary(const Manifest& manifest);

}  // namespace mien::pipeline
