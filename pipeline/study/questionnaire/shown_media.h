#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// A file that participants are shown, or may be.
struct ShownMedia {
  std::string stimulus;
  std::string path;  ///< in the study's folder: "videos/walk.mp4", "clips/walk.glb"
};

/// Of all stimuli that a questionnaire shows (shown_stimuli): their videos or, where they may be
/// turned, their motions in 3-D as well.
std::vector<ShownMedia> shown_media(const Manifest& manifest);

}  // namespace mien::pipeline
