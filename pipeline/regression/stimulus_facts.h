#pragma once

#include <string>

#include "pipeline/regression/baseline.h"
#include "pipeline/regression/rendition.h"

namespace mien::pipeline {

/// What is known of a stimulus once its motion is made: all but edition, key frames and videos.
/// Throws Error when the motion cannot be made.
StimulusFacts facts_of(const std::string& id, Rendition& rendition);

}  // namespace mien::pipeline
