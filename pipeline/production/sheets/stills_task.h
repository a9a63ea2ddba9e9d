#pragma once

#include "pipeline/manifest/determinants.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/film/film.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// The task "sheet:<id>" of a sheet of stills, as PDF and PNG, which renders the middle frame of
/// each stimulus's film. It reads the motions and the equalized properties (film_equalized.h), but
/// not the films, so it does not wait for them. `settings.output` is ignored. Sheet, manifest and
/// motions must outlive it.
Task stills_task(const Sheet& sheet, const Manifest& manifest, const FilmSettings& settings,
                 const SharedDeterminants& shared, Motions& motions);

}  // namespace mien::pipeline
