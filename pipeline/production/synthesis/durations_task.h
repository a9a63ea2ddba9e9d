#pragma once

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/determinants.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

extern const TableForm durations_form;

/// The task "durations", for studies that equalize durations: finds the duration of the shortest
/// stimulus, writes metrics/durations.csv, and records the duration (duration_record_path), so that
/// showing one motion does not require all others. `manifest` and `motions` must outlive it.
Task durations_task(const Manifest& manifest, const SharedDeterminants& shared, Motions& motions);

}  // namespace mien::pipeline
