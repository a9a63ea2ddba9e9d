#pragma once

#include <string>

namespace mien::pipeline {

/// Maximum total time in seconds for which an attempt of a job waits for a study's folder that is
/// full, read-only or unavailable.
inline constexpr int folder_wait_limit_seconds = 3600;

/// The part of a batch file that runs the command `call` and stores its exit code in $code. If the
/// command is not started, $code is worker_disk_unavailable if the study's folder was unusable for
/// $patience seconds in total, or when the job received a stop signal; `stopped` if such a signal
/// was received while the folder was usable; and worker_wrong_setup if $started cannot be entered.
/// If the command fails while the folder is full, read-only or unavailable, it is repeated when the
/// folder is usable again. Requires the shell variables $folder, $started, $log, $job and
/// $patience.
std::string job_attempts(const std::string& call, int stopped);

}  // namespace mien::pipeline
