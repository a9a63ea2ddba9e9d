#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

// The pairs that trials of two stimuli show, and the stimuli with the signal. The manifest must
// have a questionnaire.

/// Returns the ids of those of the rated stimuli (questionnaire_stimuli) or, if pairs are listed,
/// of the stimuli in these that have the signal: those that the questionnaire names or that have
/// the levels that it names. In the order of the manifest; empty if it names none.
std::vector<std::string> signal_stimuli(const Manifest& manifest);

/// Returns the pairs of two different stimuli: the listed ones; otherwise all pairs of the rated
/// stimuli that suit the form of the trials: of pair trials those with equal levels of the factors
/// of `preference: {alike}`, of two-interval trials one stimulus with the signal
/// and one without, of same–different trials with `differ_in` those whose levels of the factors of
/// the design (studied_factors) differ in that factor only.
std::vector<std::vector<std::string>> different_pairs(const Manifest& manifest);

/// Returns the pairs of a stimulus with itself for same–different trials: as many as it takes so
/// that they are the share `same` of all pairs, at least one. The stimuli of the different pairs
/// occur in proportion to how often they occur in these, so that a stimulus may occur several
/// times.
std::vector<std::vector<std::string>> same_pairs(
    const Manifest& manifest, const std::vector<std::vector<std::string>>& different);

}  // namespace mien::pipeline
