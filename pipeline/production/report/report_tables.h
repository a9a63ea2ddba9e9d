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

/// Requested and held values of a stimulus, and the values reached; empty if it names no
/// parameters. Names are in `language`.
std::string parameter_table(const Stimulus& stimulus, const Synthesis& made, Motions& motions,
                            NameLanguage language);

/// The stimulus's values on all rated parameters that are neither requested nor held, collapsed;
/// empty without ratings, and where none is requested or held.
std::string other_parameters(const Stimulus& stimulus, const Synthesis& made, Motions& motions,
                             NameLanguage language);

/// The examples with the largest weights in a motion; empty if it is not a blend.
std::string weight_table(const Synthesis& made, Motions& motions);

/// The distance between the motions of every comparison.
std::string distance_table(std::span<const Sheet* const> sheets, Motions& motions);

/// For comparisons with a reference: the number of features in which the target differs from the
/// reference, and how many of them changed in the same direction in the created motion. Empty if
/// there are none.
std::string feature_agreement_table(std::span<const Sheet* const> sheets, Motions& motions);

/// For each foil among the stimuli and each aspect, the difference from the original, and whether
/// it is intended or within the tolerance; empty without foils.
std::string foil_table(std::span<const Stimulus> stimuli, Motions& motions);

/// Returns the differences of the created motion from the reference, with those of the target for
/// comparison. Empty for sheets other than comparisons with a reference.
std::vector<motion::FeatureChange> feature_changes(const Sheet& sheet, Motions& motions);

}  // namespace mien::pipeline
