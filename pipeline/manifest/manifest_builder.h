#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// The manifest that a document describes: paths resolved from the folder of `file`, a stimulus's
/// own values laid over the manifest's. Values that are absent or of a wrong type keep their
/// defaults; check_schema tells about them.
Manifest build_manifest(const nlohmann::json& document, Places places,
                        const std::filesystem::path& file);

}  // namespace mien::pipeline
