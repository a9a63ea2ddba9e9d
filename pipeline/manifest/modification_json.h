#pragma once

#include <functional>
#include <string>

#include <nlohmann/json.hpp>

#include "pipeline/documents/places.h"
#include "pipeline/manifest/modification.h"

namespace mien::pipeline {

/// What a map of a manifest or of a file of recipes says of a modification. `path` is the map's;
/// `resolve` takes paths of files from the document's folder. The schema has been held against it.
ModificationEdit modification_edit(
    const nlohmann::json& map, const std::string& path, const Places& places,
    const std::function<std::filesystem::path(std::string)>& resolve);

/// The older method that a map names, if it does: method, neutral, styled and the method's options.
std::optional<StyleStep> style_step(const nlohmann::json& map);

}  // namespace mien::pipeline
