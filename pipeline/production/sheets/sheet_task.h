#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/determinants.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// The task "sheet:<id>", which draws a comparison or gallery sheet, as PDF and PNG. Sheet,
/// manifest and motions must outlive it.
Task sheet_task(const Sheet& sheet, const Manifest& manifest, const SharedDeterminants& shared,
                Motions& motions);

/// Adds what every sheet states about its study.
void add_printed(KeyBuilder& key, const Manifest& manifest);

/// Returns the artifacts of a sheet's task: sheets/<id>.pdf and sheets/<id>.png, in this order.
std::vector<Product> sheet_products(const Sheet& sheet);

/// Stores both files; each is read back and checked before it is published.
void put_sheet(TaskRun& run, const std::string& pdf, const std::string& png);

}  // namespace mien::pipeline
