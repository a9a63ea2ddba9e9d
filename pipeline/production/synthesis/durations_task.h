#pragma once

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/determinants.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

extern const TableForm durations_form;

/// The task "durations", for studies whose stimuli all last as long as the shortest: finds how long
/// that is, metrics/durations.csv. What shows one motion then need not read all the others.
/// `manifest` and `motions` outlive it.
Task durations_task(const Manifest& manifest, const SharedDeterminants& shared, Motions& motions);

}  // namespace mien::pipeline
