#pragma once

#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/production/run/video_seconds.h"

namespace mien::pipeline {

/// Checks that the films of continuous trials, whose durations must be given, can be rated: they
/// last longer than the lead (and the lag of the analysis), so that trials have means, and at most
/// longest_trace_seconds, so that their traces can be stored. Nothing for other trials. Returns a
/// fault for each film, at the stimulus.
std::vector<Fault> continuous_film_faults(const Manifest& manifest, const VideoSeconds& seconds);

/// Throws these as Faults, if there are any.
void check_continuous_films(const Manifest& manifest, const VideoSeconds& seconds);

}  // namespace mien::pipeline
