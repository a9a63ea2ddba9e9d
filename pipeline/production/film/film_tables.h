#pragma once

#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/determinants.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// The task "films", which writes the films' records as tidy CSV: metrics/luminance.csv, videos.csv
/// and views.csv. It reads the artifacts of all film tasks. `manifest` must outlive it. Overlays
/// have rows like stimuli.
Task films_task(const Manifest& manifest, const SharedDeterminants& shared);

/// Returns the forms of the tables of the task "films".
std::vector<TableForm> film_table_forms();

/// Returns the path of a film's record in the store.
std::string film_record_path(const std::string& stimulus);

}  // namespace mien::pipeline
