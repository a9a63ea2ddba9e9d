#pragma once

#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/determinants.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

// Tasks that cover a study as a whole. `motions` and `manifest` outlive them.

/// What all of these depend on: the manifest's own text, as ids, roles and comparisons appear in
/// tables and report, and all that motions and films are made of, which are the tasks of `graph`.
Hash study_key(const Manifest& manifest, const SharedDeterminants& shared, const TaskGraph& graph);

/// The tables of "tables".
std::vector<TableForm> study_table_forms();

/// "tables": metrics/*.csv (tables.h). Reads all motions.
Task tables_task(const Manifest& manifest, Motions& motions, const Hash& study);

/// "report": report.html (report.h), methods.md and references.bib (methods.h), and of a large
/// study the pages of its parts. Shows the products of all tasks of `graph`, so it comes last.
Task report_task(const Manifest& manifest, Motions& motions, const Hash& study,
                 const TaskGraph& graph);

}  // namespace mien::pipeline
