#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "pipeline/farm/slurm/slurm_answers.h"

namespace mien::pipeline {

/// What the operator asks of Slurm for each job; empty or 0: what the site gives by itself.
struct JobRequest {
  std::string partition;
  std::string time;
  std::string memory;
  std::string account;
  int array_limit = 0;  ///< elements of an array that may run at once
  int processors = 1;   ///< of an element
};

/// The program and the study that a job works on. All paths are absolute.
struct StudyCall {
  std::filesystem::path program;
  std::filesystem::path manifest;
  std::filesystem::path out;      ///< folder of all studies
  std::filesystem::path started;  ///< the folder that the submission was made in
  std::string study;
  std::string quality;  ///< empty: as the manifest says
  std::string key;      ///< of the study's graph: a worker makes no other (key_of)
};

/// One job array, or the job that makes what is left.
struct BatchJob {
  std::string submission;  ///< "0001"
  std::string name;        ///< "2-frames"
  std::string comment;     ///< "mien:<graph key>:0001:2-frames"
  int elements = 0;        ///< lines of `<name>.tasks`; 0: the job runs `mien run`
};

/// A batch file that `sbatch` takes from any folder, and that a person can read, change and submit
/// again. `folder` is the submission's: the file is `<folder>/<name>.sbatch`, the items lie in
/// `<name>.tasks`, logs are written into log/, and ends/ has a file for each element that did not
/// end well.
///
/// The job passes SIGTERM on. What ended with worker_transient goes back into the queue, but
/// most_restarts times at most; a wrong set-up is held. A folder that is full, read-only or away is
/// waited for (job_attempts.h); what waited in vain goes back into the queue, and is held in the
/// end.
std::string batch_script(const BatchJob& job, const std::filesystem::path& folder,
                         const StudyCall& call, const JobRequest& request, const SlurmSite& site);

/// Throws Error when a path cannot stand in a batch file: it has a line break or a backslash.
void refuse_unwritable(const std::filesystem::path& path);

/// The value of an option in a line "#SBATCH --output=…".
std::string batch_value(std::string_view text);

}  // namespace mien::pipeline
