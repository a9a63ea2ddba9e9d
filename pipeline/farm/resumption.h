#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "pipeline/farm/jobs/job_status.h"

namespace mien::pipeline {

/// Items of the pending and running elements that will proceed without intervention. `folder`: the
/// study's.
std::set<std::string> covered_items(const std::vector<JobStatus>& statuses,
                                    const std::filesystem::path& folder);

/// Slurm's IDs of jobs that a new submission replaces: those that will never run without
/// intervention (is_stuck), and the pending final jobs of earlier submissions.
std::vector<std::string> obsolete_jobs(const std::vector<JobStatus>& statuses);

/// Tasks whose jobs ran out of memory, and the memory to request for them next: twice the largest
/// amount that was too little.
struct MemoryNeeds {
  std::map<std::string, std::string> more;  ///< by task
  std::string rest;                         ///< of the final job; empty if it had enough
  std::vector<std::string> unknown;  ///< items and final jobs without a known amount to double
};

/// Determines memory needs from squeue and from out-of-memory kills that jobs recorded in ends/.
/// SIGKILL alone does not count, because it may have another cause. `folder`: the study's.
MemoryNeeds memory_needs(const std::vector<JobStatus>& statuses,
                         const std::filesystem::path& folder);

}  // namespace mien::pipeline
