#pragma once

#include <string>

namespace mien::pipeline {

/// Maximum total time in seconds for which an attempt of a job waits for a study's folder that is
/// full, read-only or unavailable.
inline constexpr int folder_wait_limit_seconds = 3600;

/// The part of a batch file that runs the command `call` and stores its exit code in $code. If the
/// command is not started, $code is
///
/// - worker_disk_unavailable if the study's folder is unusable (full, read-only or unavailable) and
///   the job has waited for it for $patience seconds in total or has received a stop signal;
/// - `stopped` if the job has received a stop signal and the folder is usable;
/// - worker_wrong_setup if the folder $started cannot be entered.
///
/// If the command fails because the study's folder is unusable, it is repeated when the folder is
/// usable again. Requires the shell variables $folder, $started, $log, $job and $patience.
std::string job_attempts(const std::string& call, int stopped);

}  // namespace mien::pipeline
