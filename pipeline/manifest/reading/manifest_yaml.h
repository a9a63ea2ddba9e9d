#pragma once

#include <filesystem>
#include <string>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// A manifest that is read as this one when it is written into `folder`: what is as it is unless
/// told is left out, and paths are taken from there. Comments of the file that it came from are not
/// kept.
std::string manifest_yaml(const Manifest& manifest, const std::filesystem::path& folder);

}  // namespace mien::pipeline
