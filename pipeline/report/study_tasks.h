#pragma once

#include "pipeline/manifest/artifact_keys.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/synthesis/motions.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

// Tasks that cover a study as a whole. `motions` and `manifest` outlive them.

/// "tables": metrics/*.csv (tables.h). Reads all motions.
Task tables_task(const Manifest& manifest, Motions& motions, const SharedDeterminants& shared);

/// "report": report.html (report.h). Shows the products of all tasks of `graph`, so it comes last.
Task report_task(const Manifest& manifest, Motions& motions, const SharedDeterminants& shared,
                 const TaskGraph& graph);

}  // namespace mien::pipeline
