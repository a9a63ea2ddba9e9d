#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Adds the faults of a motion file and of the take that is selected. `path` is
/// the path, in the manifest, of the file name or of the map that contains the file name as
/// `file:`.
void check_motion_file(const std::string& path, const std::filesystem::path& file,
                       const motion::ReadOptions& how, FaultList& list);

/// Adds a fault if a take is selected although the motion file's format holds
/// only one motion. `path` is the path of the take in the manifest.
void check_take(const std::string& path, const std::filesystem::path& file,
                const motion::ReadOptions& how, FaultList& list);

/// Adds the faults of a body model: that it cannot be read, or that the motion file (empty: of a
/// folder) is no SMPL motion. `path` is the path of the model in the manifest.
void check_body_model(const std::string& path, const std::filesystem::path& file,
                      const motion::ReadOptions& how, FaultList& list);

/// Returns a fault for each take or frame that a stimulus requests and its motion file lacks, and
/// one for each such file that cannot be interpreted. Reads only files of which a take or a frame
/// is requested, and ignores other faults of the manifest.
std::vector<Fault> check_recordings(const Manifest& manifest);

/// Returns a warning, which names the default take, for each motion file with several takes of
/// which none is selected. Reads only files that may hold several takes, and skips those that
/// cannot be read.
std::vector<Fault> default_take_warnings(const Manifest& manifest);

}  // namespace mien::pipeline
