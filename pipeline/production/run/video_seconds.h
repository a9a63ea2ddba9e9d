#pragma once

#include <map>
#include <string>

#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// Durations of videos in seconds, by stimulus.
using VideoSeconds = std::map<std::string, double>;

/// Duration of the video of each stimulus that the questionnaire shows, in seconds, including title
/// card, fixation cross and blanks. Synthesizes the motions. Throws Error if one cannot be
/// synthesized.
VideoSeconds video_seconds(const Manifest& manifest);
VideoSeconds video_seconds(const Manifest& manifest, Motions& motions);

}  // namespace mien::pipeline
