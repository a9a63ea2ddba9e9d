#pragma once

#include <vector>

#include "pipeline/regression/baseline.h"
#include "pipeline/regression/comparison.h"

namespace mien::pipeline {

/// Videos that are not as they were, by their kind. None where none were made now.
std::vector<VideoChange> video_changes(const std::vector<VideoFacts>& before,
                                       const std::vector<VideoFacts>& now);

}  // namespace mien::pipeline
