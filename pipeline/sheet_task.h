#pragma once

#include "pipeline/determinants.h"
#include "pipeline/manifest.h"
#include "pipeline/motions.h"
#include "pipeline/task_graph.h"

namespace mien::pipeline {

/// The task "sheet:<id>": compares two motions on a page, as PDF and PNG. Sheet,
/// manifest and motions outlive it.
Task sheet_task(const Sheet& sheet, const Manifest& manifest, const SharedDeterminants& shared,
                Motions& motions);

}  // namespace mien::pipeline
