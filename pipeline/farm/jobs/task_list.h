#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/farm/jobs/submission_journal.h"

namespace mien::pipeline {

/// The items on each line of a task list, which has one line per element. Returns no lines if the
/// file has been removed.
std::vector<std::vector<std::string>> lines_of_list(const std::filesystem::path& list);

/// Path of a job's task list. `folder`: the study's folder.
std::filesystem::path list_of(const JournalJob& job, const std::filesystem::path& folder);

}  // namespace mien::pipeline
