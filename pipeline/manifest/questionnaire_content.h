#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

// The content of a manifest's questionnaire with its defaults filled in. The manifest must have
// one.

/// The questionnaire. Throws Error where the manifest has none.
const Questionnaire& questionnaire_of(const Manifest& manifest);

/// The matching experiment. Throws Error where the manifest has none.
const Matching& matching_of(const Manifest& manifest);

/// Ids of the matching experiment's targets: those that it names, or all stimuli whose role is
/// target and which are no practice.
std::vector<std::string> matching_targets(const Manifest& manifest);

/// The title of the questionnaire or matching experiment, or the study's name.
std::string title_of(const Manifest& manifest);

/// The scales that it may choose from: its own file's, else those of the study and then the six of
/// the emotions that the study does not have under the same ids.
ScaleSet scales_to_choose(const Manifest& manifest);

/// The scales of the questionnaire, in the order in which they are asked. Ids that are unknown are
/// left out (the checks report them).
ScaleSet questionnaire_scales(const Manifest& manifest);

/// Ids of the stimuli that are asked about, in the order of the manifest, or of the questionnaire
/// where it names them.
std::vector<std::string> questionnaire_stimuli(const Manifest& manifest);

/// Ids of the stimuli of each trial, one or two, in the order of the trials; all pairs where the
/// questionnaire names none.
std::vector<std::vector<std::string>> questionnaire_subjects(const Manifest& manifest);

/// Ids of all stimuli that a questionnaire shows: in trials, in practice, or as reference; each
/// once, in the order of the manifest.
std::vector<std::string> shown_stimuli(const Manifest& manifest);

/// What may be chosen in a trial that offers choices: id → as shown. Those that are named, else the
/// levels of the factor emotion.
std::vector<std::pair<std::string, std::string>> questionnaire_choices(const Manifest& manifest);

/// The level of a factor of a stimulus by its id; empty where it has none.
std::string level_of(const Manifest& manifest, const std::string& stimulus,
                     const std::string& factor);

}  // namespace mien::pipeline
