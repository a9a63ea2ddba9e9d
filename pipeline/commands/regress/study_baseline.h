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

/// The folder to which approved stimuli are written: `given`, or the default folder if `given` is
/// empty. Throws Error if `given` names a commit and there is no file or folder of that name.
std::filesystem::path new_baseline(const std::string& given, const Manifest& manifest);

/// The baseline named by `given`, the value of `--baseline`. If it names a folder, that folder; if
/// it names a branch, tag or commit of the manifest's git repository, the default folder
/// (baselines/<study> next to the manifest) as committed there; if it is empty, the default folder.
/// Throws Error if there is no baseline.
FoundBaseline find_baseline(const std::string& given, const Manifest& manifest);

}  // namespace mien::pipeline
