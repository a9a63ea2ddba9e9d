#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/farm/jobs/submission_journal.h"

namespace mien::pipeline {

/// The items of each line of a task list, one line per element; an empty line has none. Returns no
/// lines if the file has been removed.
std::vector<std::vector<std::string>> lines_of_list(const std::filesystem::path& list);

/// Path of a job's task list. `folder`: the study's.
std::filesystem::path list_of(const JournalJob& job, const std::filesystem::path& folder);

}  // namespace mien::pipeline
