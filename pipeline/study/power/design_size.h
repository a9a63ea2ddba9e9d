#pragma once

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// The number of rated stimuli in each cell of the design, a combination of levels of the factors
/// that are analysed (design_factors); 0 if cells have different numbers. The manifest must have a
/// questionnaire.
int stimuli_per_cell(const Manifest& manifest);

/// The study with so many rated stimuli in each cell that has any: the first ones in the order of
/// the manifest, followed by copies of them as "a~2", "a~3" … In copies, levels of factors that are
/// not analysed are new ones, "woman~2", so that pairs of stimuli with equal levels of them are
/// pairs of copies. The number of trials per participant (per_participant) stays. Throws Error for
/// questionnaires that list their pairs or their sets of stimuli by id, and for grids of more
/// stimuli than a trial may have.
Manifest with_stimuli_per_cell(const Manifest& manifest, int count);

}  // namespace mien::pipeline
