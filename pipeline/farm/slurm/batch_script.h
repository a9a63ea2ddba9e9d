#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "pipeline/farm/slurm/slurm_output.h"

namespace mien::pipeline {

/// Resources requested from Slurm for each job. An empty text or 0 stands for the site's default.
struct JobRequest {
  std::string partition;
  std::string time;    ///< time limit: "1:30:00"
  std::string memory;  ///< "4G"
  std::string account;
  int array_limit = 0;  ///< maximum number of elements of an array running at once
  int processors = 1;   ///< per element
  std::string program;  ///< absolute path of what nodes run; empty: the program that submits
};

/// The program and the study of a job. All paths are absolute.
struct StudyCall {
  std::filesystem::path program;
  std::filesystem::path manifest;
  std::filesystem::path out;      ///< folder of all studies
  std::filesystem::path started;  ///< working directory of the submission
  std::string study;
  std::string quality;  ///< empty: that of the manifest
  std::string key;      ///< key_of the study's graph; a worker refuses any other key
};

/// One job array, or the final job that completes the study.
struct BatchJob {
  std::string submission;  ///< "0001"
  std::string name;        ///< "2-frames"
  std::string comment;     ///< "mien:<graph key>:0001:2-frames"
  int elements = 0;        ///< number of lines of `<name>.tasks`; 0: the job runs `mien run`
};

/// Text of a batch file that `sbatch` accepts from any working directory, and that a user can read,
/// edit and submit again. `folder` is the submission's: the file is `<folder>/<name>.sbatch`, its
/// items are in `<name>.tasks`, logs are written to log/, and ends/ has a file for each element
/// that failed.
///
/// The job forwards SIGTERM to the program it runs. The job is requeued after worker_transient (the
/// final job: after a stop signal), at most most_restarts times, and held after worker_wrong_setup.
/// It waits while the study's folder is full, read-only or unavailable (job_attempts.h), is
/// requeued if the folder does not become usable, and is finally held.
std::string batch_script(const BatchJob& job, const std::filesystem::path& folder,
                         const StudyCall& call, const JobRequest& request, const SlurmSite& site);

/// Throws Error if a path contains a control character, such as a line break, or a backslash, which
/// a batch file cannot express.
void refuse_unwritable(const std::filesystem::path& path);

/// The text, escaped for use as an option's value in a line "#SBATCH --output=…".
std::string batch_value(std::string_view text);

}  // namespace mien::pipeline
