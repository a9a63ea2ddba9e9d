#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Adds the faults of a motion file and of its take (empty: none). `path` is its path in the
/// manifest, of the file name itself or of a map with `file:`.
void check_motion_file(const std::string& path, const std::filesystem::path& file,
                       const std::string& take, FaultList& list);

/// Adds a fault if a take is given (empty: none) for a motion file whose format holds only one
/// motion. `path` is the path of the take in the manifest.
void check_take(const std::string& path, const std::filesystem::path& file, const std::string& take,
                FaultList& list);

/// Returns a fault for each take or frame that a stimulus requests and its motion file lacks. Reads
/// only files of which a take or a frame is requested, and ignores other faults of the manifest.
std::vector<Fault> check_recordings(const Manifest& manifest);

/// Returns a warning for each motion file with several takes of which none is selected; it names
/// the default take. Reads only files that may hold several takes, and skips those that cannot be
/// read.
std::vector<Fault> default_take_warnings(const Manifest& manifest);

}  // namespace mien::pipeline
