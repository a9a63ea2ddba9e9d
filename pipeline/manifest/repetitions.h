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

/// Told by what stimuli are made of and not by their pictures: a motion that is asked for in two
/// ways, and comes out the same, is no repetition. Point lights that are placed by chance are
/// others for each id. In the order of the manifest, whose files must be there.
std::vector<Repetition> repetitions_in(const Manifest& manifest);

/// What is said of the stimulus, without its id.
std::string to_sentence(const Repetition& repetition);

/// Each with its id: "b: a rater sees the same as of …".
std::vector<std::string> told_repetitions(const Manifest& manifest);

/// The same with its place; no fault, as both may be shown on purpose.
Fault told_at_its_place(const Repetition& repetition, const Places& places);

}  // namespace mien::pipeline
