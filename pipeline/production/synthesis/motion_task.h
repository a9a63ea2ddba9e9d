#pragma once

#include "pipeline/manifest/determinants.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

// `stimulus` and `motions` outlive these tasks.

/// The task "motion:<id>": makes the motion and notes its digest, which stands for it in the keys
/// of all that is made from it.
Task motion_task(const Stimulus& stimulus, const SharedDeterminants& shared, Motions& motions);

/// The task "clip:<id>": writes the shown motion in the formats that the output asks for.
Task clip_task(const Stimulus& stimulus, const Equalize& equalize, const SharedDeterminants& shared,
               Motions& motions);

}  // namespace mien::pipeline
