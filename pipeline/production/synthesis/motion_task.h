#pragma once

#include "pipeline/manifest/determinants.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

// `stimulus` and `motions` must outlive these tasks.

/// The task "motion:<id>", which makes the motion and records its digest. The digest represents the
/// motion in the keys of all dependent artifacts.
Task motion_task(const Stimulus& stimulus, const SharedDeterminants& shared, Motions& motions);

/// The task "clip:<id>", which writes the shown motion in the formats that the output requests.
Task clip_task(const Stimulus& stimulus, const Equalize& equalize, const SharedDeterminants& shared,
               Motions& motions);

}  // namespace mien::pipeline
