#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace mien::pipeline {

/// The folders below which a page may choose captures and characters: the manifest's folder, and
/// the folder of examples that the manifest names.
class StudioPlaces {
 public:
  /// `manifest` is the path of the manifest, which may not exist yet; `known` is its document.
  StudioPlaces(const std::filesystem::path& manifest, const nlohmann::ordered_json& known);

  /// {"folders": [{"folder": "captures", "motions": ["walk.bvh", …]}, …],
  ///  "characters": ["robot.glb", …], "all": whether that is all there is}
  ///
  /// Names are as a manifest refers to them. Left out are links to folders, hidden folders, output
  /// of mien, and entries beyond limits of depth and number.
  nlohmann::ordered_json listing() const;

  /// Whether a text names an existing folder, motion file or character in these places, with links
  /// resolved.
  bool contains(const std::string& name) const;

 private:
  struct Place {
    std::filesystem::path folder;  ///< with links resolved
    std::string name;              ///< prefix of names in it; empty: the manifest's own folder
  };

  std::filesystem::path beside_;  ///< base of relative names
  std::vector<Place> places_;
};

}  // namespace mien::pipeline
