#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/farm/jobs/job_problems.h"

namespace mien::pipeline {

/// The log of a final job or of an element of a job array.
struct ElementLog {
  std::string item;  ///< heading of the log: the item searched for, or the element and its problem
  std::filesystem::path file;
};

/// The newest log of each element whose items include `item`, from the newest submission that has
/// such logs. If the item is a task ("film:walk"), logs of its chunks are included. `folder`: the
/// study's.
std::vector<ElementLog> find_logs(const std::string& item, const std::filesystem::path& folder);

/// The newest log of each element that has one of these problems, if it has written one, with the
/// heading "0001/2-frames.3, failed (exit code 70)". `folder`: the study's.
std::vector<ElementLog> find_logs(const std::vector<JobProblem>& problems,
                                  const std::filesystem::path& folder);

/// The last `lines` lines of a file, within its last 64 KiB; empty if it cannot be opened.
std::string last_lines(const std::filesystem::path& file, int lines);

}  // namespace mien::pipeline
