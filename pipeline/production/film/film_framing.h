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

/// Computes the equalized height of all figures, or of the figures of each kind: the smallest of
/// their heights, rounded down to a multiple of 1/64 pixel. Stores it in `films` and returns the
/// content of metrics/sizes.csv.
std::string sizes_csv(const Manifest& manifest, FinishedMotions& motions, TaskRun& run,
                      EqualizedFilms& films);

/// Computes the equalized position of all figures, or of the figures of each kind: the mean of
/// their positions in the cameras' pictures, shifted as little as necessary so that every figure
/// that was within its picture stays within it. Figures have the heights given in `films`. Stores
/// the position in `films` and returns the content of metrics/places.csv. Throws Error if there is
/// no such position.
std::string places_csv(const Manifest& manifest, FinishedMotions& motions, TaskRun& run,
                       EqualizedFilms& films);

/// Throws Error if `places_csv` would find no position.
void check_places(const Manifest& manifest, FinishedMotions& motions);

}  // namespace mien::pipeline
