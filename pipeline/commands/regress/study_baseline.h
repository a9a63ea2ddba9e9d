#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/archive/scratch_folder.h"

namespace mien::pipeline {

/// A baseline on disk; one from git exists during the lifetime of this object.
struct FoundBaseline {
  std::filesystem::path folder;
  std::unique_ptr<ScratchFolder> scratch;
};

/// The folder to which approved stimuli are written. Throws Error for the name of a commit.
std::filesystem::path new_baseline(const std::string& given, const Manifest& manifest);

/// The baseline for `--baseline`: a folder, or a branch, tag or commit of the manifest's git
/// repository, from which the default folder is taken; the default folder if empty. Throws Error if
/// there is no baseline.
FoundBaseline find_baseline(const std::string& given, const Manifest& manifest);

}  // namespace mien::pipeline
