#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "pipeline/production/archive/study_contents.h"

namespace mien::pipeline {

/// A difference between a study and its provenance.
struct Finding {
  enum class Kind {
    missing,   ///< recorded, but missing
    changed,   ///< present, but with different content or not decodable
    extra,     ///< present, but not recorded
    not_kept,  ///< recorded, but removed on purpose (keep.h)
    left_out,  ///< recorded, but not packed because of its licence (packed_recordings.h)
  };
  Kind kind;
  std::string path;  ///< relative to the study's folder
  std::string what;  ///< "12 bytes instead of 521"; may be empty
};

std::string_view name_of(Finding::Kind kind);

/// The result of verifying a study.
struct Verification {
  int artifacts = 0;  ///< number of artifacts recorded in the provenance
  int inputs = 0;     ///< number of copies in inputs/ and of packed recordings
  int videos = 0;     ///< number of videos decoded
  int pictures = 0;   ///< number of pictures decoded, including the frames of sequences
  std::uint64_t bytes = 0;
  std::vector<Finding> findings;  ///< by kind, then by path

  int count(Finding::Kind kind) const;
  bool is_sound() const;  ///< nothing is missing or changed
};

/// Called as files or frames are completed, with the completed share, 0 … 1; possibly from several
/// threads, but never concurrently.
using ShareDone = std::function<void(double share, const std::string& path)>;

/// Verifies a finished study: hashes and decodes each artifact, each copied input and each packed
/// recording, and searches
/// the folder for files that are not recorded. Changes nothing and needs only the provenance; if
/// the store's receipts exist, frames that differ are named, and an edited provenance is detected.
/// Throws Interrupted after a stop request, and Error if the list of removed artifacts (keep.h) is
/// damaged.
Verification verify(const StudyContents& contents, int jobs, const std::stop_token& stop,
                    const ShareDone& done);

}  // namespace mien::pipeline
