#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// A stimulus that shows a rater what one before it shows: the same motion in the same look, size
/// and presentation, under another id.
struct Repetition {
  std::string path;  ///< "stimuli[3]"
  std::string id;
  std::string first;  ///< id of the stimulus that it repeats
};

/// Found by comparing what stimuli are made from, not their pictures: the same motion described in
/// two ways is no repetition. Randomly placed point lights differ for each id. In the order of the
/// manifest, whose files must be there.
std::vector<Repetition> repetitions_in(const Manifest& manifest);

/// A warning about the repeated stimulus, without its id.
std::string to_sentence(const Repetition& repetition);

/// A warning for each repetition, with its id: "b: a rater sees the same as of …".
std::vector<std::string> repetition_warnings(const Manifest& manifest);

/// The repetition at its place in the manifest; a warning only, as both may be shown on purpose.
Fault repetition_fault(const Repetition& repetition, const Places& places);

}  // namespace mien::pipeline
