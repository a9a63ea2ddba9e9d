#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/farm/jobs/job_troubles.h"

namespace mien::pipeline {

/// The log of an element of a job array.
struct ElementLog {
  std::string item;  ///< that it was to make, or what is to be said of it
  std::filesystem::path file;
};

/// The newest log of each element that has the item, of the newest submission that has any: of the
/// task itself and of its chunks where the item is a task ("film:walk"). `folder`: the study's.
std::vector<ElementLog> logs_of(const std::string& item, const std::filesystem::path& folder);

/// The newest log of each of these elements, those that have written one, called by its cause:
/// "0001/2-frames.3, failed (exit code 70)".
std::vector<ElementLog> logs_of(const std::vector<JobTrouble>& troubles,
                                const std::filesystem::path& folder);

/// The last lines of a file; only its last 64 KiB are read.
std::string tail_of(const std::filesystem::path& file, int lines);

}  // namespace mien::pipeline
