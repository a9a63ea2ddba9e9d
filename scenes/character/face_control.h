#pragma once

#include <string>
#include <utility>
#include <vector>

namespace mien::scenes {

/// An expression or a morph target of a character, by whose weight its face is changed.
struct FaceControl {
  std::string name;
  /// Morphs (MorphTarget::morph) with what weight 1 adds to the weight of each.
  std::vector<std::pair<int, double>> morphs;
  bool is_binary = false;  ///< weights above 0.5 count as 1, others as 0 (VRM)
};

/// The morphs of a character's meshes, and the controls that change them.
struct FaceControls {
  int morph_count = 0;
  /// Expressions of VRM, then morph targets, with the names of the file. Of several with one name
  /// the first counts.
  std::vector<FaceControl> controls;
};

}  // namespace mien::scenes
