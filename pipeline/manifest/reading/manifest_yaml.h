#pragma once

#include <filesystem>
#include <string>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// A manifest that is read as this one when it is written into `folder`: values that equal
/// their defaults are left out, and paths are relative to that folder. Comments of the file that it
/// came from are not kept.
std::string manifest_yaml(const Manifest& manifest, const std::filesystem::path& folder);

}  // namespace mien::pipeline
