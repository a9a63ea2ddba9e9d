#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "pipeline/farm/jobs/job_fates.h"

namespace mien::pipeline {

/// Items of jobs that go on by themselves. `folder`: the study's.
std::set<std::string> covered_items(const std::vector<JobFate>& fates,
                                    const std::filesystem::path& folder);

/// Live jobs in the way of a new submission: those that are stuck, and those that were to make what
/// is left of an earlier one.
std::vector<std::string> obsolete_jobs(const std::vector<JobFate>& fates);

/// Tasks for which a job had too little memory, and what to ask for next.
struct MemoryNeeds {
  std::map<std::string, std::string> more;  ///< twice as much, by task
  std::vector<std::string> unknown;         ///< items of jobs that asked for nothing in particular
};

/// From what Slurm still knows, and from what the jobs left in ends/ that saw their control group
/// count a kill for want of memory. SIGKILL alone says nothing: anybody may have sent it.
MemoryNeeds memory_needs(const std::vector<JobFate>& fates, const std::filesystem::path& folder);

/// "4G" of "2G", "3000M" of "1500"; empty when the text is no amount of memory.
std::string twice_the_memory(const std::string& memory);

}  // namespace mien::pipeline
