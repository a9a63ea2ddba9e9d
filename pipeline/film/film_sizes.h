#pragma once

#include <filesystem>
#include <string>

#include "pipeline/manifest/manifest.h"
#include "pipeline/synthesis/motions.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// metrics/sizes.csv, a row a stimulus: stimulus, framed_px (height of the standing figure where
/// its camera shows it), figure_px (that of all films that are
/// made alike: the least of these).
std::string sizes_csv(const Manifest& manifest, Motions& motions, TaskRun& run);

/// What the table has for a stimulus, in the store's folder. Throws Error.
double figure_px_of(const std::filesystem::path& folder, const std::string& stimulus);

}  // namespace mien::pipeline
