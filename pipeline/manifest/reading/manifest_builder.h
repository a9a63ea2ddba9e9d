#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "pipeline/base/reading/yaml_json.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// The manifest that a document describes, as it was written: paths resolved from the folder of
/// `file`, a stimulus's own values laid over the manifest's. Values that are absent or of a wrong
/// type keep their defaults; check_schema tells about them. Reads no file: each that the document
/// names, or each folder, is told to `names` as it is written and as it is resolved.
Manifest build_manifest(
    JsonReading reading, const std::filesystem::path& file,
    const std::function<void(const std::string&, const std::filesystem::path&)>& names = {});

}  // namespace mien::pipeline
