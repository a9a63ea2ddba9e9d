#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include <nlohmann/json.hpp>

#include "scenes/cameras/camera_settings.h"
#include "scenes/figures/figure.h"

namespace mien::pipeline {

/// What `figure:` and `camera:` of a manifest say: a name, or a map of options. `resolve` takes
/// paths of files from the document's folder. The schema has been held against the values.
scenes::Figure figure_from(const nlohmann::json& given,
                           const std::function<std::filesystem::path(const std::string&)>& resolve);
scenes::CameraSettings camera_from(const nlohmann::json& given);

}  // namespace mien::pipeline
