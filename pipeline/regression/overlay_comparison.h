#pragma once

#include <map>
#include <string>
#include <vector>

#include "pipeline/regression/regression.h"

namespace mien::pipeline {

/// Returns the facts about an overlay, without its videos: its settings, what it is made with, and
/// as its motion a digest of the motions of its stimuli. Edition, scene and key frames are empty.
StimulusFacts overlay_facts(const Overlay& overlay, Rendition& rendition);

/// Compares the selected overlays with the baseline by their videos, and adds them to the result,
/// whose stimuli have been compared. A video differs by its number of frames, rate or sound, and by
/// other frames, unless these are explained by noise (another seed, program, library or processor)
/// or by motions that are within their limits or were approved after the overlay: the comparison of
/// the stimuli shows whether these are accepted. `videos` are the current videos by id; those
/// without an entry were not made.
void compare_overlays(const ComparedStudy& study,
                      const std::map<std::string, std::vector<VideoFacts>>& videos,
                      Regression& result);

}  // namespace mien::pipeline
