#pragma once

#include <string>

namespace mien::pipeline {

/// Seconds that an attempt of a job waits, all in all, for a study's folder that is full, read-only
/// or away.
inline constexpr int folder_patience_seconds = 3600;

/// The part of a batch file that runs `call`, a command, until it ends for a reason of its own, and
/// leaves its code in $code: worker_no_disk when the folder was not well for as long as $patience
/// lasted, `stopped` when the job was told to stop before it began. What fails while the study's
/// folder is full, read-only or away is tried again once it is well. Needs $folder, $started, $log,
/// $job and $patience.
std::string job_attempts(const std::string& call, int stopped);

}  // namespace mien::pipeline
