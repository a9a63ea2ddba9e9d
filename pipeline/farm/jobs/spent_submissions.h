#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "pipeline/farm/jobs/job_fates.h"

namespace mien::pipeline {

/// So many of the newest submissions keep their folders.
inline constexpr std::size_t kept_submissions = 3;

/// Older submissions whose folders nobody needs any more, by number: none of their jobs waits or
/// runs, and nothing of what they were to make is `due` (tasks that are to be made). `folder`: the
/// study's.
std::vector<std::string> spent_submissions(const std::vector<JobFate>& fates,
                                           const std::set<std::string>& due,
                                           const std::filesystem::path& folder);

/// Removes the batch files, lists, notes and logs of submissions. The journal keeps what they were,
/// and their numbers. How many had a folder.
int remove_submissions(const std::vector<std::string>& numbers,
                       const std::filesystem::path& folder);

}  // namespace mien::pipeline
