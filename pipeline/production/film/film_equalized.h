#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/manifest/artifact_keys.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/clips/finished_motions.h"
#include "pipeline/production/film/film.h"
#include "pipeline/production/film/film_shot.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// What a study makes alike in its films, for one of them.
struct Equalized {
  float exposure_stops = 0.0f;  ///< added to the tone's; EXR files keep the light as it is
  Framing framing;
};

/// Those of the tasks "sizes" and "places" (metrics/sizes.csv, metrics/places.csv: film_framing.h)
/// and "exposure" (metrics/exposure.csv: film_exposure.h) that `manifest.equalize` asks for. Each
/// goes by what those before it found, and all by durations (clips/durations.h), whose task comes
/// before them. They read all motions and look at all stimuli. `manifest` and `motions` outlive
/// them.
std::vector<Task> equalizing_tasks(const Manifest& manifest, const SharedDeterminants& shared,
                                   const FilmSettings& settings, FinishedMotions& motions);

/// The tables that they and the task of durations make, in the store's folder: drawing a film anew
/// needs all of them.
std::vector<std::string> equalizing_tables(const Equalize& equalize);

/// Their names, for what waits for them.
std::vector<std::string> equalizing_task_ids(const Equalize& equalize);

/// What they found for a stimulus, in the store's folder; of durations it is the motions that are
/// told. Throws Error.
Equalized equalized_film(const Equalize& equalize, const std::filesystem::path& folder,
                         const std::string& stimulus, FinishedMotions& motions);

}  // namespace mien::pipeline
