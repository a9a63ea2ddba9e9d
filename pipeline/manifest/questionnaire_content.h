#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

// The content of a manifest's questionnaire or matching experiment, with defaults filled in. Unless
// stated otherwise, the manifest must have a questionnaire.

/// Returns the questionnaire. Throws Error if the manifest has none.
const Questionnaire& questionnaire_of(const Manifest& manifest);

/// Returns the matching experiment. Throws Error if the manifest has none.
const Matching& matching_of(const Manifest& manifest);

/// Returns the adaptive experiment. Throws Error if the manifest has none.
const Adaptive& adaptive_of(const Manifest& manifest);

/// Returns the ids of the matching experiment's targets: the named ones, or all stimuli with the
/// role of a target that are not used for practice. The manifest must have a matching experiment.
std::vector<std::string> matching_targets(const Manifest& manifest);

/// Returns the title of the questionnaire or, if the manifest has none, of the matching or adaptive
/// experiment; if the title is empty, the study's name. Throws Error if the manifest has none.
std::string title_of(const Manifest& manifest);

/// Returns the scales from which the questionnaire may choose: those of its own file; otherwise the
/// study's, followed by those of the six emotion scales whose ids the study does not use.
ScaleSet scales_to_choose(const Manifest& manifest);

/// Returns the scales of the questionnaire, in the order in which they are asked. Unknown ids are
/// omitted (the checks report them). In grid and continuous trials, all scales range from 0 to 100.
ScaleSet questionnaire_scales(const Manifest& manifest);

/// Returns whether scales are answered on sliders.
bool has_sliders(const Questionnaire& asked);

/// Returns how often the main part of a session is gone through: in continuous trials once for each
/// scale, otherwise 1.
std::size_t scales_in_turn(const Manifest& manifest);

/// Returns the ids of the rated stimuli, in the order in which the questionnaire names them (also
/// in sets of grid trials) or, if it does not name stimuli, in that of the manifest.
std::vector<std::string> questionnaire_stimuli(const Manifest& manifest);

/// Returns whether a choice of stimuli includes one.
bool is_chosen(const Stimulus& stimulus, const StimulusChoice& choice);

/// Returns what trials can show: one stimulus each, in the order of questionnaire_stimuli, or the
/// pairs of two different stimuli (different_pairs), followed in same–different trials by those of
/// a stimulus with itself (same_pairs), of which several are equal, or the sets of grid trials
/// (grid_sets). None of sets for best–worst trials: the study makes them (trial_subjects.h).
std::vector<std::vector<std::string>> questionnaire_subjects(const Manifest& manifest);

/// Returns the number of stimuli that a trial shows, apart from a reference; 0 if it varies (grid
/// trials).
std::size_t stimuli_per_trial(const Questionnaire& asked);

/// Returns the number of what trials can show, sets included.
std::size_t questionnaire_subject_count(const Manifest& manifest);

/// Returns the number of trials of a session whose answers are analysed, if it is completed; of
/// continuous trials, those on one scale; of adaptive trials, the most that there can be.
int analysed_trials(const Manifest& manifest);

/// Returns the number of trials of the main part, warm-up and repeated ones among them; of
/// continuous trials, those on one scale.
int main_trials(const Manifest& manifest);

/// Returns the number of attention checks of a session, about: none comes after the last trial of
/// the main part or, in continuous trials, of a scale.
int attention_checks(const Manifest& manifest);

/// Returns the ids of all stimuli that a questionnaire shows in trials, in practice or as
/// reference, without duplicates, in the order of the manifest.
std::vector<std::string> shown_stimuli(const Manifest& manifest);

/// Returns whether the stimuli of a pair are shown side by side or one after the other.
PairPresentation pair_presentation(const Questionnaire& asked);

/// Returns the possible answers of a trial that offers choices, as id → displayed text: the named
/// ones, otherwise the levels of the factor `emotion`.
std::vector<std::pair<std::string, std::string>> questionnaire_choices(const Manifest& manifest);

/// Returns the level of a factor for the stimulus with that id; empty if it has none.
std::string level_of(const Manifest& manifest, const std::string& stimulus,
                     const std::string& factor);

}  // namespace mien::pipeline
