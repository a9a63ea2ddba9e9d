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
  float exposure_stops = 0.0f;  ///< added to the tone's; EXR files keep the light as it is
  Framing framing;
};

/// The equalized properties of all films, by stimulus id; empty where a property is not equalized
/// or not computed yet.
struct EqualizedFilms {
  std::map<std::string, double> exposure_stops;
  std::map<std::string, double> figure_px;                    ///< height of the standing figure
  std::map<std::string, std::array<double, 2>> figure_place;  ///< scenes/cameras/figure_place.h

  Equalized of(const std::string& stimulus) const;
};

/// The tasks among "sizes" and "places" (metrics/sizes.csv, metrics/places.csv: film_framing.h)
/// and "exposure" (metrics/exposure.csv: film_exposure.h) that `manifest.equalize` asks for. Beside
/// its table, which is for people, each writes all that has been found so far,
/// .mien/equalized/<task>.json. They go by durations (clips/finished_motions.h), whose task comes
/// before them. They read all motions and look at all stimuli. `manifest` and `motions` outlive
/// them.
std::vector<Task> equalizing_tasks(const Manifest& manifest, const SharedDeterminants& shared,
                                   const FilmSettings& settings, FinishedMotions& motions);

/// Their names and that of the task of durations, for what waits for them.
std::vector<std::string> equalizing_task_ids(const Equalize& equalize);

/// Reads the records of these tasks from the store's folder; the shortest duration is passed to
/// `motions`. Throws where there is no such record.
EqualizedFilms equalized_films(const Equalize& equalize, const std::filesystem::path& folder,
                               FinishedMotions& motions);

}  // namespace mien::pipeline
