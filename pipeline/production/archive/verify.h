#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "pipeline/production/archive/study_contents.h"

namespace mien::pipeline {

/// Something about a study that differs from its provenance.
struct Finding {
  enum class Kind {
    missing,   ///< recorded, and not there
    changed,   ///< there, with other bytes, or it does not decode
    extra,     ///< there, and made by nobody that is known
    not_kept,  ///< recorded, and removed on purpose (keep.h)
  };
  Kind kind;
  std::string path;  ///< in the study's folder
  std::string what;  ///< "12 bytes instead of 521"; may be empty
};

std::string_view name_of(Finding::Kind kind);

/// What was looked at, and what was found.
struct Verification {
  int artifacts = 0;  ///< recorded in the provenance
  int inputs = 0;     ///< copies in inputs/
  int videos = 0;     ///< decoded
  int pictures = 0;   ///< decoded, frames of sequences counted one by one
  std::uint64_t bytes = 0;
  std::vector<Finding> findings;  ///< by kind, then by path

  int count(Finding::Kind kind) const;
  bool is_sound() const;  ///< nothing is missing or changed
};

/// Called after each file; from several threads, one call at a time.
using ShareDone = std::function<void(double share, const std::string& path)>;

/// Reads everything of a finished study: each artifact is hashed and decoded, each copied input
/// hashed, and the folder searched for what nobody made. Changes nothing, and needs no more than
/// the provenance; where the store's receipts are there, single frames are checked, and an edited
/// provenance is found. Throws Interrupted after a stop request, and Error as contents_of does.
Verification verify(const StudyContents& contents, int jobs, const std::stop_token& stop,
                    const ShareDone& done);

}  // namespace mien::pipeline
