#pragma once

#include <filesystem>
#include <string>

#include "pipeline/base/documents/fault_list.h"

namespace mien::pipeline {

/// Adds the fault of a take (none: empty) that is wanted of a motion file which can hold one motion
/// only; `path` is where the take stands in the manifest.
void check_take(const std::string& path, const std::filesystem::path& file, const std::string& take,
                FaultList& list);

}  // namespace mien::pipeline
