#pragma once

#include "pipeline/manifest/walk_path.h"

namespace mien::pipeline {

/// The path with its moods of adjectives turned into moods of the set's walks: the shares of the
/// blend that a stimulus of these adjectives would be, which has them or comes nearest to them, by
/// what is rated of the built-in walks on the built-in scales. Moods of walks stay as they are.
/// Throws Error when the method cannot take so many adjectives.
WalkPath in_walks(WalkPath path);

}  // namespace mien::pipeline
