#pragma once

#include <string>
#include <vector>

#include "pipeline/farm/jobs/job_problems.h"
#include "pipeline/farm/jobs/worker_reports.h"

namespace mien::pipeline {

/// Observations that show whether a job that is running according to Slurm is alive.
struct LivenessEvidence {
  std::vector<WorkerReport> workers;
  NodeStates nodes;
  bool folder_is_usable = true;  ///< false: the folder is unavailable; jobs wait without a worker
};

/// Jobs that are running or completing according to Slurm but are most likely dead: their node does
/// not respond, or cannot end them, or their workers have not reported for several minutes. Their
/// remedies give the commands that cancel them. `study`: its arguments in commands.
std::vector<JobProblem> unresponsive_jobs(const std::vector<JobStatus>& statuses,
                                          const LivenessEvidence& evidence,
                                          const std::string& study);

}  // namespace mien::pipeline
