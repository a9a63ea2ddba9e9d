#pragma once

#include "pipeline/manifest/determinants.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/film/film.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// The task "sheet:<id>" of a sheet of stills, as PDF and PNG: draws the middle frame of each
/// stimulus's film as the film has it. It reads motions, and exposures where luminance is
/// equalized, but not the films, so it need not wait for them. The output in `settings` is of no
/// concern. Sheet, manifest and motions outlive it.
Task stills_task(const Sheet& sheet, const Manifest& manifest, const FilmSettings& settings,
                 const SharedDeterminants& shared, Motions& motions);

}  // namespace mien::pipeline
