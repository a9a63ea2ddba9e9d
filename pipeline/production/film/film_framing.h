#pragma once

#include <string>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/clips/finished_motions.h"
#include "pipeline/production/film/film_equalized.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

extern const TableForm sizes_form;
extern const TableForm places_form;

/// Finds how tall all figures are, and returns metrics/sizes.csv.
std::string sizes_csv(const Manifest& manifest, FinishedMotions& motions, TaskRun& run,
                      EqualizedFilms& films);

/// Finds where all figures stand: the mean of the places that the cameras show, moved as far as it
/// must be for every figure to stay within its picture that was within it before. Figures are as
/// tall as `films` has them. Returns metrics/places.csv. Throws Error where no
/// place is left.
std::string places_csv(const Manifest& manifest, FinishedMotions& motions, TaskRun& run,
                       EqualizedFilms& films);

/// Throws Error where `places_csv` would find no place.
void check_places(const Manifest& manifest, FinishedMotions& motions);

}  // namespace mien::pipeline
