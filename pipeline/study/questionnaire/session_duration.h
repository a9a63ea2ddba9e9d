#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// Sessions with a longer expected duration, in seconds, cause a warning. Participants of the
/// emotion thesis found 40 videos too long.
inline constexpr double recommended_session_seconds = 20.0 * 60.0;

/// Expected duration of a session, seconds: reading texts, answering questions about the
/// participant, testing the sound and measuring screen and viewing distance, watching each video
/// once (videos side by side play simultaneously) and answering each item, commenting, and the
/// pauses between trials (Pace).
double session_seconds(const Manifest& manifest, const SessionPlan& plan,
                       const VideoSeconds& seconds);

/// The expected durations of sessions as all that name them state them: "6.2 min", "6.2 to 7.4
/// min".
std::string duration_text(const std::vector<SessionPlan>& plans);

/// Number of words in a text. In scripts written without spaces, two characters count as a word.
double word_count(std::string_view text);

}  // namespace mien::pipeline
