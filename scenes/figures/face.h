#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mien::scenes {

/// Weights of facial expressions and morph targets, each from 0 to 1, by name.
using FaceWeights = std::vector<std::pair<std::string, double>>;

/// How the face of a character is shown; by default as its file has it. At most one of the members
/// `is_hidden`, `weights` and `file` is set.
struct Face {
  bool is_hidden = false;  ///< behind a plain oval (hidden_face.h)
  FaceWeights weights;     ///< the same in all frames

  /// A table of weights (face_table.h), or a glTF file with animated weights (face_animation.h).
  std::filesystem::path file;
  std::string take;                         ///< animation of a glTF file; empty: its first
  double start_s = 0.0;                     ///< seconds of the film at which the file begins
  std::optional<double> frames_per_second;  ///< of a table that counts frames

  bool is_neutral() const { return !is_hidden && weights.empty() && file.empty(); }

  friend bool operator==(const Face&, const Face&) = default;
};

}  // namespace mien::scenes
