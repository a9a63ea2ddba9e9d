#pragma once

#include <filesystem>

#include "pipeline/manifest/artifact_keys.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/synthesis/motions.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

inline constexpr char durations_task_id[] = "durations";

/// The task "durations", for studies whose stimuli all last as long as the shortest: finds how long
/// that is. What shows one motion then need not read all the others. `manifest` and `motions`
/// outlive it.
Task durations_task(const Manifest& manifest, const SharedDeterminants& shared, Motions& motions);

/// Tells the motions what it found, in the store's folder. Throws std::runtime_error when there is
/// nothing.
void know_durations(const std::filesystem::path& folder, Motions& motions);

}  // namespace mien::pipeline
