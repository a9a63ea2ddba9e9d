#pragma once

#include <string>

#include "scenes/character/character.h"

namespace mien::scenes {

/// The character as a GLB file (skinned_glb.h); `rig_pose` returns the transforms of its joints.
/// Throws as `skinned_glb`.
std::string to_glb(const Character& character);

}  // namespace mien::scenes
