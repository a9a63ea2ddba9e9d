#pragma once

#include "motion/text/words.h"
#include "pipeline/base/documents/concerns.h"

namespace mien::pipeline {

/// How the marker of a continuous rating is moved.
enum class TraceInput {
  slider,  ///< by mouse, touch, or arrow keys
  keys,    ///< by arrow keys only
};

/// Where the marker is when the film begins.
enum class TraceStart { middle, low };

inline constexpr Words<TraceInput> trace_input_words = {{"slider", TraceInput::slider},
                                                        {"keys", TraceInput::keys}};
inline constexpr Words<TraceStart> trace_start_words = {{"middle", TraceStart::middle},
                                                        {"low", TraceStart::low}};

/// Continuous ratings: participants move a marker on a scale while a film plays, once. The position
/// of the marker over the time of the film is a trace (ratings/answers/trace.h).
struct ContinuousSettings {
  TraceInput input = TraceInput::slider;
  TraceStart start = TraceStart::middle;  ///< middle of the scale, or its low end
  /// Seconds from the beginning of the film that the mean of a trial leaves out, since the marker
  /// is still near its start.
  double lead = 1.0;
  double speed = 50.0;  ///< of the marker while an arrow key is held, in hundredths of the scale/s
};

void fields_of(auto&& field, MaybeConst<ContinuousSettings> auto& continuous) {
  field("input", continuous.input, concerns::nothing, trace_input_words);
  field("start", continuous.start, concerns::nothing, trace_start_words);
  field("lead", continuous.lead, concerns::nothing);
  field("speed", continuous.speed, concerns::nothing);
}

}  // namespace mien::pipeline
