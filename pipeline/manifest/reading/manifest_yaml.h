#pragma once

#include <filesystem>
#include <string>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// Returns YAML that, saved in `folder`, is read as the same manifest. Default values are omitted
/// unless the schema requires them, and paths are relative to that folder. Comments of the original
/// file are not kept.
std::string manifest_yaml(const Manifest& manifest, const std::filesystem::path& folder);

}  // namespace mien::pipeline
