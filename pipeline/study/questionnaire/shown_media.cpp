#include "pipeline/study/questionnaire/shown_media.h"

#include <algorithm>

#include "pipeline/manifest/asked.h"
#include "render/video/video_kind.h"

namespace mien::pipeline {

std::vector<ShownMedia> shown_media(const Manifest& manifest) {
  std::vector<ShownMedia> media;
  const std::vector<std::string> shown = shown_stimuli(manifest);
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (std::ranges::find(shown, stimulus.id) == shown.end()) continue;
    for (const render::VideoKind kind : stimulus.output.video) {
      const std::string name = render::with_ending(stimulus.id, kind).string();
      media.push_back({stimulus.id, "videos/" + name});
    }
    if (questionnaire_of(manifest).view == ShownAs::turn)
      media.push_back({stimulus.id, "clips/" + stimulus.id + ".glb"});
  }
  return media;
}

}  // namespace mien::pipeline
