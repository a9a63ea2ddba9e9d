#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/farm/jobs/submission_journal.h"

namespace mien::pipeline {

/// The items of each line of a list, one line an element; an empty line has none. No lines where
/// the file has been removed.
std::vector<std::vector<std::string>> lines_of_list(const std::filesystem::path& list);

/// Where a job's list lies. `folder`: the study's.
std::filesystem::path list_of(const JournalJob& job, const std::filesystem::path& folder);

}  // namespace mien::pipeline
