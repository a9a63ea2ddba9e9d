#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace mien::pipeline {

/// Where a page may choose captures and characters: below the manifest's folder, and below the
/// folder of examples that the manifest names, wherever that lies.
class StudioPlaces {
 public:
  /// `manifest` is its file, there or not; `known` is what it says.
  StudioPlaces(const std::filesystem::path& manifest, const nlohmann::ordered_json& known);

  /// {"folders": [{"folder": "captures", "motions": ["walk.bvh", …]}, …],
  ///  "characters": ["robot.glb", …], "all": whether that is all there is}
  ///
  /// Names are as the manifest would have them. Left out are links to folders, hidden folders, what
  /// mien has made, and all beyond some depth and number.
  nlohmann::ordered_json listed() const;

  /// Whether a text names a folder, a motion file or a character that is there, links followed.
  bool hold(const std::string& name) const;

 private:
  struct Place {
    std::filesystem::path folder;  ///< links followed
    std::string name;              ///< before names in it; empty: the manifest's own folder
  };

  std::filesystem::path beside_;  ///< what relative names are taken from
  std::vector<Place> places_;
};

}  // namespace mien::pipeline
