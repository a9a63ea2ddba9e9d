#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/determinants.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

// Tasks that cover a study as a whole. `motions` and `manifest` must outlive them.

/// Returns the key on which these tasks depend. It covers the manifest's own text, because ids,
/// roles and comparisons appear in tables and report, the contents of `documents`, the files that
/// it names besides motions and characters, and the tasks of `graph`, which stand for the inputs of
/// all motions and films.
Hash study_key(const Manifest& manifest, const std::vector<std::filesystem::path>& documents,
               const SharedDeterminants& shared, const TaskGraph& graph);

/// Returns the forms of the tables of the task "tables".
std::vector<TableForm> study_table_forms();

/// The task "tables", which writes metrics/*.csv (tables.h). It reads all motions.
Task tables_task(const Manifest& manifest, Motions& motions, const Hash& study);

/// The task "report", which writes report.html (report.h), methods.md and references.bib
/// (methods.h) and, for a large study, the pages of its parts. It shows the artifacts of all tasks
/// of `graph`, so it must be added last.
Task report_task(const Manifest& manifest, Motions& motions, const Hash& study,
                 const TaskGraph& graph);

}  // namespace mien::pipeline
