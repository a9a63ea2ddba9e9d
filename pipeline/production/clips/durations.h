#pragma once

#include <array>
#include <filesystem>

#include "pipeline/base/documents/table.h"
#include "pipeline/production/clips/finished_motions.h"

namespace mien::pipeline {

inline constexpr char durations_task_id[] = "durations";

inline constexpr std::array durations_columns = std::to_array<Column>({
    {"stimulus", "", "id of the stimulus"},
    {"own_s", "s", "duration of its film before equalizing"},
    {"duration_s", "s", "duration of all films, to the nearest frame: the shortest of these"},
});

inline constexpr TableForm durations_form = {
    "metrics/durations.csv", "stimulus, if duration is equalized", durations_columns};

/// Holds how long all films are: a number of seconds in JSON, in the store's folder.
inline constexpr char duration_record_path[] = ".mien/equalized/duration.json";

/// Throws where the file holds no number.
double recorded_duration(const std::filesystem::path& file);

/// Tells the motions what was found, in the store's folder. Throws when there is nothing.
void know_durations(const std::filesystem::path& folder, FinishedMotions& motions);

}  // namespace mien::pipeline
