#pragma once

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// The task "design": metrics/stimuli.csv, metrics/warnings.csv (stimuli_table.h) and
/// metrics/codebook.json (codebook.h). It reads the products of the motions, clips and films of
/// `graph`. `study` is the study's key; `manifest` and `motions` outlive the task.
Task design_task(const Manifest& manifest, Motions& motions, const Hash& study,
                 const TaskGraph& graph);

}  // namespace mien::pipeline
