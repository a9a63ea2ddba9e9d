#pragma once

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/determinants.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// The table of `clips: [csv]`, as motion::to_tidy_csv writes it.
extern const TableForm clip_points_form;

// `stimulus` and `motions` must outlive these tasks.

/// The task "motion:<id>", which makes the motion and records its digest. The digest represents the
/// motion in the keys of all dependent artifacts.
Task motion_task(const Stimulus& stimulus, const SharedDeterminants& shared, Motions& motions);

/// The task "clip:<id>", which writes the shown motion in the formats that the output requests. In
/// formats of points these are the joints or, of recorded points that could not be fitted to a
/// body, the points.
Task clip_task(const Stimulus& stimulus, const Equalize& equalize, const SharedDeterminants& shared,
               Motions& motions);

/// A sentence on a format of `output: clips` in which the motion cannot be written; empty if all
/// can. Makes the motion. Throws Error if that is not possible.
std::string unwritable_clip(const Stimulus& stimulus, Motions& motions);

}  // namespace mien::pipeline
