#pragma once

#include <string>
#include <vector>

#include "pipeline/regression/comparer.h"

namespace mien::pipeline {

/// A stimulus that the baseline has not, with a picture of it. Where the baseline has one that is
/// gone now and was the same motion in the same scene, it is told to have been called so. Throws
/// Error and Interrupted.
StimulusComparison appeared(const std::string& id, const ComparedStudy& study);

/// A stimulus that the manifest has no more, with a picture of it. `others` are told already: what
/// appeared may be the same under another name. Throws Error when the baseline is damaged.
StimulusComparison gone(const StimulusFacts& approved, const ComparedStudy& study,
                        const std::vector<StimulusComparison>& others);

}  // namespace mien::pipeline
