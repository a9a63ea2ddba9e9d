#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "pipeline/farm/jobs/job_status.h"

namespace mien::pipeline {

/// A job, or an element of an array, that needs the user's attention.
struct JobProblem {
  enum class Kind {
    held,      ///< held by Slurm; it will not run by itself
    outdated,  ///< live, but submitted for an earlier state of the study, so it produces nothing
    unresponsive,  ///< running according to Slurm, but its node or worker does not respond
    ended,         ///< ended without completing its work items
    cancelled      ///< cancelled before completing its work items
  };
  Kind kind = Kind::ended;
  std::string submission;  ///< "0001"
  std::string element;     ///< "2-frames.3"; "6-rest.1" for the job that completes a submission
  std::string job;         ///< Slurm's job ID: "17_3"
  std::string reason;      ///< Slurm's reason: "JobHeldUser"; empty if no longer known
  std::string cause;       ///< "failed (exit code 70)"
  std::string remedy;      ///< the command that continues, and what to do first
};

/// The present state of a study, against which its jobs are compared.
struct StudyState {
  std::filesystem::path folder;
  std::string graph_key;           ///< graph_key of the study (submission.h)
  std::set<std::string> done;      ///< tasks whose artifacts exist
  bool has_all_artifacts = false;  ///< every task is done
  bool is_complete = false;        ///< every task is done, and provenance.json describes the result
  std::string words;  ///< the study's arguments in suggested commands: "my.yaml --out o"
};

/// Problems of the jobs of all submissions, in order of submission. A failed job is listed as long
/// as one of its work items (work_item.h) is unfinished and has not been submitted again. Jobs that
/// ended before the study was changed are not listed, nor are unresponsive jobs
/// (unresponsive_jobs.h). Based on squeue and on the exit codes that jobs record in ends/.
std::vector<JobProblem> job_problems(const std::vector<JobStatus>& statuses,
                                     const StudyState& study);

/// Problems as text for the terminal, grouped by kind and cause.
std::string problems_text(const std::vector<JobProblem>& problems);

}  // namespace mien::pipeline
