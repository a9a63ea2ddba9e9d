#pragma once

#include <string_view>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// Sessions that are expected to take longer are warned about: the participants of the emotion
/// thesis found 40 videos too long.
inline constexpr double longest_good_session_seconds = 20.0 * 60.0;

/// What a session is expected to take: its texts read, its questions answered, every video seen
/// once (those beside each other at the same time), every item answered (Pace).
double session_seconds(const Manifest& manifest, const SessionPlan& plan,
                       const VideoSeconds& seconds);

/// Words to read in a text. Of writing without blanks, two characters count as a word.
double words_in(std::string_view text);

/// Seconds of the videos of these stimuli as they are shown, card, cross and blanks included. Makes
/// their motions. Throws Error.
VideoSeconds video_seconds(const Manifest& manifest);

}  // namespace mien::pipeline
