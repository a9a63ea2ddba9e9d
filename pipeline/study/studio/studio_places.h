#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace mien::pipeline {

/// The folders from which a page may choose captures and characters, including their subfolders:
/// the manifest's folder, and the folder of examples that the manifest names.
class StudioPlaces {
 public:
  /// `manifest` is the path of the manifest, which may not exist yet; `known` is its document.
  StudioPlaces(const std::filesystem::path& manifest, const nlohmann::ordered_json& known);

  /// {"folders": [{"folder": "captures", "motions": ["walk.bvh", …]}, …],
  ///  "characters": ["robot.glb", …], "all": whether the listing is complete}
  ///
  /// Names are written as in a manifest. Omitted are symbolic links to folders, hidden folders,
  /// output of mien, and entries that exceed the limits of depth and number.
  nlohmann::ordered_json listing() const;

  /// Whether `name` refers to an existing folder, motion file or character in these folders after
  /// symbolic links are resolved.
  bool contains(const std::string& name) const;

 private:
  struct Place {
    std::filesystem::path folder;  ///< with symbolic links resolved
    std::string name;  ///< prefix of the names of its files; empty for the manifest's folder
  };

  std::filesystem::path beside_;  ///< the manifest's folder, the base of relative names
  std::vector<Place> places_;
};

}  // namespace mien::pipeline
