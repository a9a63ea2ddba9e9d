#pragma once

#include <vector>

#include "motion/measures/differences/feature_change.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// How the created motion of a comparison differs from the reference, beside how the target does.
/// Empty for sheets that are no comparison with a reference.
std::vector<motion::FeatureChange> feature_changes(const Sheet& sheet, Motions& motions);

}  // namespace mien::pipeline
