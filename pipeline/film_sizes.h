#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/determinants.h"
#include "pipeline/manifest.h"
#include "pipeline/motions.h"
#include "pipeline/task_graph.h"

namespace mien::pipeline {

/// What a study makes alike in its films, for one of them.
struct Equalized {
  float exposure_stops = 0.0f;      ///< added to the tone's; EXR files keep the light as it is
  std::optional<double> figure_px;  ///< height of the standing figure
};

/// From the products of the tasks "exposure" and "sizes", as far as `equalize` asks for them.
/// Throws Error.
Equalized equalized_film(const Equalize& equalize, const std::filesystem::path& folder,
                         const std::string& stimulus);

/// Names of those tasks, which films that are equalized wait for.
std::vector<std::string> equalizing_tasks(const Equalize& equalize);

/// The task "sizes": metrics/sizes.csv, a row a stimulus: stimulus, framed_px (height of the
/// standing figure where its camera shows it), figure_px (that of all films: the least of these).
/// It reads all motions. `manifest` and `motions` outlive it.
Task sizes_task(const Manifest& manifest, const SharedDeterminants& shared, Motions& motions);

/// What the task found for a stimulus, in the store's folder. Throws Error.
double figure_px_of(const std::filesystem::path& folder, const std::string& stimulus);

}  // namespace mien::pipeline
