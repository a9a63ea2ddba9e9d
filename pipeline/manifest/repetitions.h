#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// A stimulus that looks the same as an earlier one: the same motion in the same look, size and
/// presentation, under another id.
struct Repetition {
  std::string path;  ///< "stimuli[3]"
  std::string id;
  std::string first;  ///< id of the stimulus that it repeats
};

/// Returns the repetitions in the order of the manifest, whose files must exist. Compares the
/// inputs of stimuli, not their pictures: the same motion described in two ways is not found.
/// Point-light figures with random dots and no stated seed look different for each id.
std::vector<Repetition> repetitions_in(const Manifest& manifest);

/// Returns a warning without the id of the repetition itself: `looks identical to "a"; …`.
std::string to_sentence(const Repetition& repetition);

/// Returns a warning for each repetition, with its id: `b: looks identical to "a"; …`.
std::vector<std::string> repetition_warnings(const Manifest& manifest);

/// Returns the repetition as a fault with its position in the manifest. It is only a warning,
/// because repetition may be intended.
Fault repetition_fault(const Repetition& repetition, const Places& places);

}  // namespace mien::pipeline
