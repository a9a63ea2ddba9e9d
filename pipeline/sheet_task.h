#pragma once

#include "pipeline/manifest.h"
#include "pipeline/motions.h"
#include "pipeline/task_graph.h"

namespace mien::pipeline {

/// The task "sheet:<id>": compares two motions on a page, as PDF and PNG. The arguments outlive it.
Task sheet_task(const Sheet& sheet, const Manifest& manifest, Motions& motions);

}  // namespace mien::pipeline
