#pragma once

#include "pipeline/manifest.h"
#include "pipeline/motions.h"
#include "pipeline/task_graph.h"

namespace mien::pipeline {

// `stimulus`, `manifest` and `motions` outlive these tasks.

/// The task "motion:<id>": makes the motion and notes its digest, which stands for it in the keys
/// of all that is made from it.
Task motion_task(const Stimulus& stimulus, const Manifest& manifest, Motions& motions);

/// The task "clip:<id>": writes the shown motion in the formats that the output asks for.
Task clip_task(const Stimulus& stimulus, Motions& motions);

}  // namespace mien::pipeline
