#pragma once

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// Checks that the films of continuous trials, whose durations must be given, can be rated: they
/// last longer than the lead (and the lag of the analysis), so that trials have means, and at most
/// longest_trace_seconds, so that their traces can be stored. Nothing for other trials. Throws
/// Faults with a fault for each film, at the stimulus.
void check_continuous_films(const Manifest& manifest, const VideoSeconds& seconds);

}  // namespace mien::pipeline
