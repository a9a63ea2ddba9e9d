#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pipeline/production/archive/study_contents.h"
#include "pipeline/production/archive/verify.h"
#include "pipeline/production/film/film_record.h"

namespace mien::pipeline {

/// The result of checking one artifact.
struct ArtifactCheck {
  std::vector<Finding> findings;
  std::uint64_t bytes = 0;  ///< bytes read
  int videos = 0;           ///< number of videos decoded
  int pictures = 0;         ///< number of pictures decoded
};

/// Hashes and decodes a file. `video`: the video's entry in its film's record, if the file is a
/// video and has one; its number of frames and duration are then compared, too.
ArtifactCheck check_file(const std::filesystem::path& folder, const ArtifactRecord& record,
                         const std::optional<VideoRecord>& video = {});

/// Checks a frame sequence, frame by frame.
ArtifactCheck check_frames(const std::filesystem::path& folder, const ArtifactRecord& record);

}  // namespace mien::pipeline
