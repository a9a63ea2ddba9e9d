#pragma once

#include <span>
#include <string>
#include <vector>

#include "motion/measures/differences/feature_change.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/production/synthesis/synthesis.h"

namespace mien::pipeline {

// Tables of report.html.

/// Requested and held values of a stimulus, and the values reached. Empty when it names no
/// parameters. Names are in the language.
std::string parameter_table(const Stimulus& stimulus, const Synthesis& made, Motions& motions,
                            InterfaceLanguage language);

/// The stimulus's values on all other rated parameters, collapsed; empty without ratings.
std::string other_parameters(const Stimulus& stimulus, const Synthesis& made, Motions& motions,
                             InterfaceLanguage language);

/// The examples that have the most weight in a motion. Empty for a file shown as it is.
std::string weight_table(const Synthesis& made, Motions& motions);

/// The distance between the motions of every comparison.
std::string distance_table(std::span<const Sheet* const> sheets, Motions& motions);

/// For comparisons with a reference: how many features changed in the target's direction. Empty
/// without any.
std::string feature_agreement_table(std::span<const Sheet* const> sheets, Motions& motions);

/// What the foils among some stimuli and those that they are of differ in; empty without foils.
std::string foil_table(std::span<const Stimulus> stimuli, Motions& motions);

/// How the created motion of a comparison differs from the reference, beside how the target does.
/// Empty for sheets that are no comparison with a reference.
std::vector<motion::FeatureChange> feature_changes(const Sheet& sheet, Motions& motions);

}  // namespace mien::pipeline
