#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/ratings/answers/expectation.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

// What tables and report say about stimuli in a word.

/// Whose ratings a motion rests on: "given", "simulated", or "none" for features, weights, files
/// and examples (nullptr).
std::string ratings_of(const Stimulus* stimulus, Motions& motions);

/// What a motion is made from: "adjectives", "features", "weights", "clip" or "path".
std::string_view source_of(const Stimulus& stimulus);

/// The stimuli that are made from that source.
std::vector<const Stimulus*> stimuli_from(const Manifest& manifest, std::string_view source);

/// How the weights were found; empty for a file shown as it is.
std::string method_of(const Stimulus& stimulus);

/// The set: "studio", or the name of its file.
std::string scene_name(const Look& look);

/// Whether a study makes anything with its examples.
bool uses_examples(const Manifest& manifest);

/// What became of the manifest's expectations; empty without ratings.
std::vector<ExpectationCheck> expectation_checks(const Manifest& manifest,
                                                 const Repertoire& repertoire);

}  // namespace mien::pipeline
