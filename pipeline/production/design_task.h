#pragma once

#include "pipeline/manifest/artifact_keys.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/synthesis/motions.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// The task "design": metrics/stimuli.csv, metrics/warnings.csv (stimuli_table.h) and
/// metrics/codebook.json (codebook.h). It reads the products of the motions, clips and films of
/// `graph`. `manifest` and `motions` outlive it.
Task design_task(const Manifest& manifest, Motions& motions, const SharedDeterminants& shared,
                 const TaskGraph& graph);

}  // namespace mien::pipeline
