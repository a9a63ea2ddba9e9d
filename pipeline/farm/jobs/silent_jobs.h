#pragma once

#include <string>
#include <vector>

#include "pipeline/farm/jobs/job_troubles.h"
#include "pipeline/farm/jobs/worker_reports.h"

namespace mien::pipeline {

/// By what one sees whether a job that runs, as Slurm counts, is alive.
struct SignsOfLife {
  std::vector<WorkerReport> workers;
  NodeStates nodes;
  bool folder_is_well = true;  ///< else jobs wait for it, without a worker
};

/// Jobs that Slurm counts as running, or as about to end, and that are most likely dead: their node
/// does not answer, or cannot get rid of them, or no worker of theirs has been heard of for
/// minutes. With the commands that give them up. `study`: how it is told in commands.
std::vector<JobTrouble> silent_jobs(const std::vector<JobFate>& fates, const SignsOfLife& signs,
                                    const std::string& study);

}  // namespace mien::pipeline
