#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pipeline/manifest/determinants.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/clips/finished_motions.h"
#include "pipeline/production/film/film.h"
#include "pipeline/production/film/film_shot.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// The equalized properties of one film.
struct Equalized {
  /// Added to the exposure of the tone curve; EXR files are not affected.
  float exposure_stops = 0.0f;
  Framing framing;
};

/// The equalized properties of all films, one map per property, by stimulus id. A map is empty if
/// its property is not equalized or has not been computed yet.
struct EqualizedFilms {
  std::map<std::string, double> exposure_stops;
  std::map<std::string, double> figure_px;  ///< height of the standing figure in pixels
  std::map<std::string, std::array<double, 2>> figure_place;  ///< scenes/cameras/figure_place.h

  Equalized of(const std::string& stimulus) const;
};

/// Returns those of the equalizing tasks "sizes", "places" and "exposure" that `manifest.equalize`
/// requires. They write the tables metrics/sizes.csv and metrics/places.csv (film_framing.h) and
/// metrics/exposure.csv (film_exposure.h). In addition to its table, each task writes all equalized
/// properties found so far to .mien/equalized/<task>.json. The tasks read all motions and stage all
/// stimuli, cut to the equalized duration if durations are equalized. `manifest` and `motions` must
/// outlive them.
std::vector<Task> equalizing_tasks(const Manifest& manifest, const SharedDeterminants& shared,
                                   const FilmSettings& settings, FinishedMotions& motions);

/// Returns the ids of the tasks that `equalize` requires, including "durations", for tasks that
/// depend on them.
std::vector<std::string> equalizing_task_ids(const Equalize& equalize);

/// Reads the records of the equalizing tasks from the store's folder; the shortest duration is
/// passed to `motions`. Throws if a record is missing.
EqualizedFilms equalized_films(const Equalize& equalize, const std::filesystem::path& folder,
                               FinishedMotions& motions);

}  // namespace mien::pipeline
