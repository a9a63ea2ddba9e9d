#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "pipeline/regression/baseline.h"

namespace mien::pipeline {

/// Maximum total size of the videos embedded in a page, in bytes; further videos are stored next to
/// it.
inline constexpr std::uintmax_t most_video_bytes = 32U << 20U;

/// The videos in a report, for stimuli whose baseline stores videos.
class ReportVideos {
 public:
  ReportVideos() = default;

  /// `study`: folder of a study with its current videos; `report`: folder for videos that are not
  /// embedded, created if necessary.
  ReportVideos(std::filesystem::path study, std::filesystem::path report,
               std::uintmax_t most_bytes = most_video_bytes)
      : study_(std::move(study)), report_(std::move(report)), bytes_left_(most_bytes) {}

  /// Returns the videos of a stimulus for the page's script: {"before", "now"} with "src", "frames"
  /// (number of frames of the whole video), "first" (index of the film's first frame) and "fps". Of
  /// the formats that browsers play, uses the first in which the baseline stores a video and the
  /// study has one; null if there is none, or if no videos were made. Throws Error if the
  /// baseline's video is damaged, and the errors of reading and writing.
  nlohmann::ordered_json of(const std::string& id, const Baseline& baseline);

 private:
  std::filesystem::path study_;  ///< empty: no videos were made
  std::filesystem::path report_;
  std::uintmax_t bytes_left_ = 0;
};

}  // namespace mien::pipeline
