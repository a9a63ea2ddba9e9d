#pragma once

#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Stimuli that a questionnaire shows as videos and that are written in no kind that browsers play:
/// one fault for all of them.
std::vector<Fault> check_shown_videos(const Manifest& manifest);

/// What a questionnaire may ask for, and yet hardly means: attention checks that can leave nobody
/// out, or that do not come. The manifest must have no faults.
std::vector<Fault> questionnaire_warnings(const Manifest& manifest);

}  // namespace mien::pipeline
