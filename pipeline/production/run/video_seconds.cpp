#include "pipeline/production/run/video_seconds.h"

#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/production/film/film_presentation.h"
#include "pipeline/production/film/film_sound.h"

namespace mien::pipeline {

VideoSeconds video_seconds(const Manifest& manifest) {
  Motions motions(manifest);
  return video_seconds(manifest, motions);
}

VideoSeconds video_seconds(const Manifest& manifest, Motions& motions) {
  VideoSeconds seconds;
  for (const std::string& id : shown_stimuli(manifest)) {
    const Stimulus* stimulus = motions.stimulus(id);
    if (stimulus == nullptr) continue;
    const Output& output = stimulus->output;
    const int frames = motions.shown_frames(*stimulus);
    const bool may_hold = stimulus->sound && stimulus->sound->length == SoundLength::hold;
    const int held = may_hold ? film_sound(*stimulus, {}, frames)->held_frames : 0;
    seconds[id] = frames_of(output.presentation, output.fps, frames, held).all() / output.fps;
  }
  return seconds;
}

}  // namespace mien::pipeline
