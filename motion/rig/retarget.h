#pragma once

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Retargets a clip to another body by keeping all rotations. The root's path is scaled about the
/// world origin by the ratio of leg lengths, so that steps stay in proportion, and then shifted
/// vertically as a whole so that the feet rest on the floor as before. Both bodies are canonical
/// (`is_body`).
Clip retarget(const Clip& clip, const Skeleton& body);

}  // namespace mien::motion
