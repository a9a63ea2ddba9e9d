#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

// The sets of stimuli of grid trials. The manifest must have a questionnaire.

/// A set of stimuli that are rated in one trial.
struct GridSet {
  std::vector<std::string> stimuli;  ///< ids
  std::string reference;             ///< id of one of them; empty: none
  std::string anchor;                ///< id of one of them; empty: none
};

/// Returns the sets of the main part: the listed ones, or the rated stimuli with equal levels of
/// the factors of `alike`, in the order of their first stimuli. Empty unless trials are of the form
/// `grid`.
std::vector<GridSet> grid_sets(const Manifest& manifest);

/// Returns the sets of the practice stimuli: those with equal levels or, if sets are listed, one
/// set of all of them.
std::vector<GridSet> practice_grid_sets(const Manifest& manifest);

/// Returns whether a choice of reference or anchor names any stimuli.
bool is_stated(const StimulusChoice& choice);

/// Returns those of the stimuli that are chosen, in their order; none if the choice names none.
std::vector<std::string> chosen_among(const Manifest& manifest,
                                      const std::vector<std::string>& stimuli,
                                      const StimulusChoice& choice);

}  // namespace mien::pipeline
