#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace mien::scenes {

/// A round cone a bone and a sphere a joint.
struct StickOptions {
  friend bool operator==(const StickOptions&, const StickOptions&) = default;
};

/// A smooth body, made from the clip's own proportions.
struct MannequinOptions {
  double build = 0.5;  ///< 0 slim … 1 heavy
  double sex = 0.5;    ///< 0 female … 1 male

  friend bool operator==(const MannequinOptions&, const MannequinOptions&) = default;
};

/// A skinned character out of a glTF file.
struct CharacterOptions {
  std::filesystem::path file;

  friend bool operator==(const CharacterOptions&, const CharacterOptions&) = default;
};

/// What stands for the moving body, with everything that can be said of it.
using Figure = std::variant<StickOptions, MannequinOptions, CharacterOptions>;

/// The key that a manifest has for it: "stick", "mannequin", "character".
std::string_view name_of(const Figure& figure);

/// Figures that need no options: what `look: {figure: …}` takes as a mere name.
std::vector<std::string> figure_names();

}  // namespace mien::scenes
