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

/// The inputs and settings of comparing a study with its baseline.
struct ComparedStudy {
  const Baseline& baseline;
  Rendition& now;
  /// Returns the approved study as this program makes it. Called only if something may have
  /// changed. Throws Error if it cannot be made; causes are then inferred from the manifests.
  std::function<Rendition&(const std::string& edition)> approved;
  const ComparedPictures* pictures = nullptr;  ///< receives the frames that differ; may be null
  int threads = 1;
  std::stop_token stop;
  std::vector<std::string> only;  ///< ids of the stimuli to compare; empty: all

  bool compares(const std::string& id) const;
};

struct ComparisonOptions {
  bool always_draw = false;  ///< render key frames even if none of their inputs has changed
  bool with_videos = false;  ///< the videos were made, so those that are missing are reported
};

/// Compares a stimulus that exists in both states, and determines why it differs. `now` are its
/// current facts, including its videos, if they were made. Throws Error and Interrupted.
StimulusComparison compare(const StimulusFacts& now, const ComparedStudy& study,
                           const ComparisonOptions& options);

/// Returns the changed videos by format; empty if no videos were approved.
std::vector<VideoChange> video_changes(const std::vector<VideoFacts>& before,
                                       const std::vector<VideoFacts>& now);

}  // namespace mien::pipeline
