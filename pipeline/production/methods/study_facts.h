#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/ratings/answers/expectation.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

// Single-word facts about stimuli for tables and reports.

/// Returns the kind of ratings on which a motion is based: "given", "simulated", or "none" for
/// features, weights, files and paths, and for examples, for which `stimulus` is nullptr.
std::string ratings_of(const Stimulus* stimulus, Motions& motions);

/// Returns the source of a motion: "adjectives", "features", "weights", "clip", "path" or, of a
/// stimulus with several, "people".
std::string_view source_of(const Stimulus& stimulus);

/// Returns the stimuli and people with that source.
std::vector<const Stimulus*> stimuli_from(const Manifest& manifest, std::string_view source);

/// Returns the method by which the weights were computed, "direct" for given weights; empty for a
/// motion file or path.
std::string method_of(const Stimulus& stimulus);

/// Returns where one of several people is, when the motion begins, and whether it is another's:
/// "at x 0.6 m, z 0 m, turned by 90°, begins at 0.5 s".
std::string person_facts(const Person& person);

/// Returns the look of a stimulus with the figure and the face of one of its people.
Look look_of_person(const Stimulus& stimulus, const Person& person);

/// Returns the name of a look's set ("studio") or, if the set is read from a file, the file's name.
std::string scene_name(const Look& look);

/// Return the options of a look's figure with its hands, and of its camera, other than its view,
/// that differ from the defaults, as JSON; empty if there are none.
std::string figure_options(const Look& look);
std::string camera_options(const Look& look);

/// As `figure_options`, with what people of the stimulus have instead, under "people" by their
/// names.
std::string figure_options(const Stimulus& stimulus);

/// Whether the motion of any stimulus of a study uses its examples.
bool uses_examples(const Manifest& manifest);

/// Returns the results of checking the manifest's expectations; empty without ratings.
std::vector<ExpectationCheck> expectation_checks(const Manifest& manifest,
                                                 const Repertoire& repertoire);

}  // namespace mien::pipeline
