#pragma once

#include <map>
#include <string>
#include <vector>

#include "pipeline/regression/regression.h"

namespace mien::pipeline {

/// Returns the facts about an overlay, without its videos: its settings, and what it is made with.
/// An overlay has no motion of its own and no key frames; edition, motion and scene are empty.
StimulusFacts overlay_facts(const Overlay& overlay, Rendition& rendition);

/// Compares the selected overlays with the baseline by their videos, and adds them to the result,
/// whose stimuli have been compared. A video differs by its number of frames, rate or sound, and by
/// other frames, unless these are explained by noise (another seed, program, library or processor)
/// or by motions within their limits: the key frames of the stimuli show whether these are
/// accepted. `videos` are the current videos by id; those without an entry were not made.
void compare_overlays(const ComparedStudy& study,
                      const std::map<std::string, std::vector<VideoFacts>>& videos,
                      Regression& result);

}  // namespace mien::pipeline
