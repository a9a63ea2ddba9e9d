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
  std::uint64_t bytes = 0;  ///< size of the checked files
  int videos = 0;           ///< number of videos decoded
  int pictures = 0;         ///< number of pictures decoded
};

/// Compares a file's size and hash with the record and, if they agree, decodes it. `video`: the
/// entry of a video in its film's record, if there is one; its number of frames and duration are
/// then checked against the file.
ArtifactCheck check_file(const std::filesystem::path& folder, const ArtifactRecord& record,
                         const std::optional<VideoRecord>& video = {});

/// Checks a frame sequence and decodes its frames. Without the store's receipt, the frames that
/// differ cannot be named.
ArtifactCheck check_frames(const std::filesystem::path& folder, const ArtifactRecord& record);

}  // namespace mien::pipeline
