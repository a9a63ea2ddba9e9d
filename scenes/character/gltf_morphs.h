#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scenes/character/character_file.h"
#include "scenes/character/face_control.h"

namespace mien::scenes {

/// The morphs of a glTF file: one for each target of each placed mesh.
struct GltfMorphs {
  int count = 0;
  std::vector<int> first;                       ///< by placed mesh: its first morph
  std::vector<std::vector<std::string>> names;  ///< by placed mesh: of its targets
};

/// The names of a mesh's targets: those in its `extras.targetNames`, as most programs write them,
/// or else "target_0", "target_1" …
std::vector<std::string> target_names(const CharacterFile& file, int mesh);

/// Throws mien::Error if there are more targets than supported.
GltfMorphs gltf_morphs(const CharacterFile& file, const std::vector<PlacedMesh>& placed);

/// The targets of one primitive in the mesh's own space: the vertices that each moves or turns, and
/// normals if the file states them. `use` names the primitive in messages. Throws mien::Error for
/// targets with other numbers of vertices, indices out of range and unsuitable numbers, and if
/// `values_left`, which is counted down, is exceeded.
std::vector<MorphTarget> primitive_morphs(const CharacterFile& file,
                                          const nlohmann::json& primitive, const std::string& use,
                                          std::size_t vertices, int first_morph,
                                          std::size_t& values_left);

/// The controls of a file's face: its VRM expressions (vrm_expressions.h), and its morph targets,
/// of which those with one name move together.
FaceControls gltf_face(const CharacterFile& file, const std::vector<PlacedMesh>& placed,
                       const GltfMorphs& morphs, std::vector<std::string>& warnings);

}  // namespace mien::scenes
