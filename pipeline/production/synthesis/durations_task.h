#pragma once

#include <array>
#include <filesystem>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/artifact_keys.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

inline constexpr char durations_task_id[] = "durations";

inline constexpr std::array durations_columns = std::to_array<Column>({
    {"stimulus", "", "id of the stimulus"},
    {"own_s", "s", "how long its film would be by itself"},
    {"duration_s", "s", "how long all films are, to their nearest frame: the least of these"},
});

inline constexpr TableForm durations_form = {
    "metrics/durations.csv", "a stimulus, where duration is equalized", durations_columns};

/// The task "durations", for studies whose stimuli all last as long as the shortest: finds how long
/// that is, metrics/durations.csv. What shows one motion then need not read all the others.
/// `manifest` and `motions` outlive it.
Task durations_task(const Manifest& manifest, const SharedDeterminants& shared, Motions& motions);

/// Tells the motions what it found, in the store's folder. Throws Error when there is nothing.
void know_durations(const std::filesystem::path& folder, Motions& motions);

}  // namespace mien::pipeline
