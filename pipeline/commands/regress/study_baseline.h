#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/archive/scratch_folder.h"

namespace mien::pipeline {

/// A baseline on disk. If it was extracted from git, its folder is removed with this object.
struct FoundBaseline {
  std::filesystem::path folder;
  std::unique_ptr<ScratchFolder> scratch;  ///< only for a baseline from git
};

/// The folder to which approved stimuli are written. Throws Error for the name of a commit.
std::filesystem::path new_baseline(const std::string& given, const Manifest& manifest);

/// The baseline for `--baseline`: a folder, or a branch, tag or commit of the manifest's git
/// repository, whose default folder is used; the default folder if `given` is empty. Throws Error
/// if there is no baseline.
FoundBaseline find_baseline(const std::string& given, const Manifest& manifest);

}  // namespace mien::pipeline
