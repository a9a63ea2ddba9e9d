#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include <nlohmann/json.hpp>

#include "scenes/cameras/camera_settings.h"
#include "scenes/figures/figure.h"

namespace mien::pipeline {

/// How a clip becomes a picture.
struct Look {
  /// A set that comes with the program, or a file's path; empty: studio, or void for point lights.
  std::string scene;
  std::filesystem::path scene_file;  ///< resolved; empty for a set that comes with the program
  std::string background;            ///< "#rrggbb" instead of the set's own; empty: its own
  scenes::Figure figure;
  scenes::CameraSettings camera;

  /// The above as they were written, in one spelling: what the pictures depend on, up to the
  /// contents of files.
  std::string written = R"({"camera":"three-quarter","figure":"stick"})";

  friend bool operator==(const Look&, const Look&) = default;
};

/// The name of the set, also where it was left open.
std::string scene_of(const Look& look);

/// Lays what a map says over a look: each of scene, figure and camera as a whole. `resolve` takes
/// paths from the document's folder. The schema has been held against the map.
void overlay(const nlohmann::json& given, Look& look,
             const std::function<std::filesystem::path(const std::string&)>& resolve);

}  // namespace mien::pipeline
