#pragma once

#include <string>

#include "pipeline/farm/jobs/job_fates.h"
#include "pipeline/farm/slurm/slurm_answers.h"

namespace mien::pipeline {

/// Why a job is stopped ("held by hand"), and what to do about it.
struct TroubleWords {
  std::string cause;
  std::string remedy;
};

/// Meaning of an exit code: one of worker_codes.h, or one of `mien run` for the job that completes
/// a submission (`is_rest`). `study`: its arguments in commands, "my.yaml --out o".
TroubleWords words_of_end(const ElementEnd& end, bool is_rest, const std::string& study);

/// Cause for a job that Slurm ended before it could record an exit code. `study`: as above.
TroubleWords words_of_state(const QueueRow& row, const std::string& study);

/// Cause for a job that Slurm holds, if no exit code explains it. `study`: as above.
TroubleWords words_of_hold(const QueueRow& row, const std::string& study);

/// Cause for jobs submitted before the study was edited. `study`: as above.
TroubleWords words_of_edit(const std::string& study);

}  // namespace mien::pipeline
