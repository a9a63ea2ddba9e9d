#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Adds the faults of a motion file that stands at `path`, by itself or as `file:` of a map there,
/// and of its take (none: empty).
void check_motion_file(const std::string& path, const std::filesystem::path& file,
                       const std::string& take, FaultList& list);

/// Adds the fault of a take (none: empty) that is wanted of a motion file which can hold one motion
/// only; `path` is where the take stands in the manifest.
void check_take(const std::string& path, const std::filesystem::path& file, const std::string& take,
                FaultList& list);

/// Takes and frames that the motion files of the manifest's stimuli do not hold, each where it
/// stands. Reads the files of which a take or a frame is asked for; what else is wrong with the
/// manifest does not matter.
std::vector<Fault> check_recordings(const Manifest& manifest);

/// Motion files with several takes of which none is chosen, and which is taken. Reads files
/// that may hold several; those that cannot be read are passed over.
std::vector<Fault> default_take_warnings(const Manifest& manifest);

}  // namespace mien::pipeline
