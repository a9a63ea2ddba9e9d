#pragma once

#include "pipeline/determinants.h"
#include "pipeline/film.h"
#include "pipeline/manifest.h"
#include "pipeline/motions.h"
#include "pipeline/task_graph.h"

namespace mien::pipeline {

/// The task "film:<id>": stages a stimulus's motion, draws it and encodes it while it is drawn. Its
/// products are what the stimulus's output asks for, a contact sheet, and a record of what was
/// drawn and checked. It reads the product of "motion:<id>", and that of "exposure" where luminance
/// is equalized. `motions` and `stimulus` outlive it.
Task film_task(const Stimulus& stimulus, const FilmSettings& settings,
               const SharedDeterminants& shared, Motions& motions, const Equalize& equalize);

}  // namespace mien::pipeline
