#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pipeline/production/archive/study_contents.h"
#include "pipeline/production/archive/verify.h"
#include "pipeline/production/film/film_record.h"

namespace mien::pipeline {

/// What the check of one artifact found.
struct ArtifactCheck {
  std::vector<Finding> findings;
  std::uint64_t bytes = 0;  ///< read
  int videos = 0;           ///< decoded
  int pictures = 0;         ///< decoded
};

/// Hashes and decodes a file. `video`: what its film's record says of it, if it is one and has one.
ArtifactCheck check_file(const std::filesystem::path& folder, const ArtifactRecord& record,
                         const std::optional<VideoRecord>& video = {});

/// Checks a sequence of frames, frame by frame.
ArtifactCheck check_frames(const std::filesystem::path& folder, const ArtifactRecord& record);

}  // namespace mien::pipeline
