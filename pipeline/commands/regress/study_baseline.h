#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/archive/scratch_folder.h"

namespace mien::pipeline {

/// A baseline on disk; one from git is there as long as this lives.
struct FoundBaseline {
  std::filesystem::path folder;
  std::unique_ptr<ScratchFolder> scratch;
};

/// The folder that approved stimuli are put into. Throws Error for the name of a commit.
std::filesystem::path new_baseline(const std::string& given, const Manifest& manifest);

/// What `--baseline` means: a folder, or a branch, tag or commit of the git repository in which the
/// manifest lies, of which the usual folder is taken; empty: the usual folder as it lies there.
/// Throws Error when there is no baseline.
FoundBaseline find_baseline(const std::string& given, const Manifest& manifest);

}  // namespace mien::pipeline
