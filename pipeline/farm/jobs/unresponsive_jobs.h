#pragma once

#include <string>
#include <vector>

#include "pipeline/farm/jobs/job_problems.h"
#include "pipeline/farm/jobs/worker_reports.h"

namespace mien::pipeline {

/// Evidence of whether a job that is running according to Slurm is alive.
struct LivenessEvidence {
  std::vector<WorkerReport> workers;
  NodeStates nodes;
  bool folder_is_usable = true;  ///< false: the study's folder is full, read-only or unavailable,
                                 ///< so that jobs wait without a worker
};

/// Jobs that are running or completing according to Slurm but are most likely dead: the node does
/// not respond or cannot end the job, or the job's workers have not reported for several minutes.
/// The remedies contain the commands that cancel the jobs. `study`: the study's arguments in
/// commands.
std::vector<JobProblem> unresponsive_jobs(const std::vector<JobStatus>& statuses,
                                          const LivenessEvidence& evidence,
                                          const std::string& study);

}  // namespace mien::pipeline
