#pragma once

#include <string>
#include <vector>

#include "scenes/character/character_file.h"
#include "scenes/character/face_control.h"
#include "scenes/character/gltf_morphs.h"

namespace mien::scenes {

/// The expressions of a VRM file, as far as they move morph targets: of VRM 1.0 the presets and the
/// file's own, of VRM 0.x the groups of blend shapes. Presets of VRM 0.x have the names of VRM 1.0:
/// "happy" for joy, "angry", "sad" for sorrow, "relaxed" for fun, "aa", "ih", "ou", "ee", "oh",
/// "blink", "blinkLeft", "blinkRight", "lookUp", "lookDown", "lookLeft", "lookRight", "neutral".
/// Changes of materials and of textures are omitted; so are, with a warning, morph targets that do
/// not exist.
std::vector<FaceControl> vrm_expressions(const CharacterFile& file,
                                         const std::vector<PlacedMesh>& placed,
                                         const GltfMorphs& morphs,
                                         std::vector<std::string>& warnings);

}  // namespace mien::scenes
