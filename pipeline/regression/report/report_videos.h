#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "pipeline/regression/baseline.h"

namespace mien::pipeline {

/// Videos of a page should take no more than that; what is more lies beside it.
inline constexpr std::uintmax_t most_video_bytes = 32U << 20U;

/// The videos that a report shows: of stimuli whose baseline keeps them.
class ReportVideos {
 public:
  ReportVideos() = default;

  /// The videos of a study in the folder `study`; what does not fit into the page goes to the
  /// folder `report`, which is made.
  ReportVideos(std::filesystem::path study, std::filesystem::path report,
               std::uintmax_t most_bytes = most_video_bytes)
      : study_(std::move(study)), report_(std::move(report)), bytes_left_(most_bytes) {}

  /// For the page's script: {"before", "now"} with "src", "frames" of the film alone, the "first"
  /// of them, and "fps". Of the first kind that browsers show and both have; null without. Throws
  /// Error where the baseline's video is damaged, and what reading and writing do.
  nlohmann::ordered_json of(const std::string& id, const Baseline& baseline);

 private:
  std::filesystem::path study_;  ///< empty: no videos were made
  std::filesystem::path report_;
  std::uintmax_t bytes_left_ = 0;
};

}  // namespace mien::pipeline
