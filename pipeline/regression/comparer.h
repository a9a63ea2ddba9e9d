#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "pipeline/regression/baseline.h"
#include "pipeline/regression/compared_pictures.h"
#include "pipeline/regression/comparison.h"
#include "pipeline/regression/rendition.h"

namespace mien::pipeline {

/// What stimuli are compared with, and by what means.
struct ComparedStudy {
  const Baseline& baseline;
  Rendition& now;
  /// The approved study, made by this program. Called only where something may have changed. Throws
  /// Error when it cannot be; causes then go by what the manifests say.
  std::function<Rendition&(const std::string& edition)> approved;
  const ComparedPictures* pictures = nullptr;  ///< takes the frames that differ, if any
  int threads = 1;
  std::stop_token stop;
  std::vector<std::string> only;  ///< ids of the stimuli that are compared; empty: all

  bool compares(const std::string& id) const;
};

/// Compares a stimulus that both have on every level, and finds out why it differs. `now` are its
/// facts, with the videos that were made of it, if any. `always_draw`: draws its key frames
/// although nothing that they depend on has changed. Throws Error and Interrupted.
StimulusComparison compare(const StimulusFacts& now, const ComparedStudy& study, bool always_draw);

/// Videos that are not as they were, by their kind. None where none were made now.
std::vector<VideoChange> video_changes(const std::vector<VideoFacts>& before,
                                       const std::vector<VideoFacts>& now);

}  // namespace mien::pipeline
