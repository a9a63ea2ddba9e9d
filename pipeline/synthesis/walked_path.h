#pragma once

#include "motion/skeleton/clip.h"
#include "pipeline/manifest/walk_path.h"

namespace mien::pipeline {

/// What a path asks for, walked by a walker under control on the standard body, from the first
/// frame to the last: a clip that does not loop. Planted feet stand. A turn goes on at the pace of
/// the walk before it, and is on the spot where nothing is walked before. By a graph, it is cut
/// from the files' motions, on the body of the first. Throws Error.
motion::Clip walked(const WalkPath& path, double frames_per_second);

}  // namespace mien::pipeline
