#pragma once

#include <filesystem>

#include "pipeline/production/clips/finished_motions.h"

namespace mien::pipeline {

inline constexpr char durations_task_id[] = "durations";

/// Holds how long all films are: a number of seconds in JSON, in the store's folder.
inline constexpr char duration_record_path[] = ".mien/equalized/duration.json";

/// Throws where the file holds no number.
double recorded_duration(const std::filesystem::path& file);

/// Tells the motions what was found, in the store's folder. Throws when there is nothing.
void know_durations(const std::filesystem::path& folder, FinishedMotions& motions);

}  // namespace mien::pipeline
