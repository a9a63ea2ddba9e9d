#pragma once

#include <string>

#include "scenes/mannequin/mannequin.h"

namespace mien::scenes {

/// A mannequin that was made for that body as a GLB file (skinned_glb.h); its joints are the
/// body's. Readers of glTF skin it linearly, so that wrists and shoulders that twist get a little
/// thinner than in films. Throws Error.
std::string to_glb(const Mannequin& mannequin, const motion::Skeleton& body);

}  // namespace mien::scenes
