#pragma once

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// The same rotations on another body. The root's path is scaled about the origin of the floor by
/// the ratio of leg lengths, so that steps stay in proportion, and then lifted or sunk as a whole
/// until the feet rest on the floor as before. Both bodies are canonical (`is_body`).
Clip retarget(const Clip& clip, const Skeleton& body);

}  // namespace mien::motion
