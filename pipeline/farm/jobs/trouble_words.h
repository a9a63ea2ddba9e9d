#pragma once

#include <string>

#include "pipeline/farm/jobs/job_fates.h"
#include "pipeline/farm/slurm/slurm_answers.h"

namespace mien::pipeline {

/// Why jobs do not go on ("held by hand"), and what to do about it.
struct TroubleWords {
  std::string cause;
  std::string remedy;
};

/// What an exit code means (worker_codes.h; of the job for what is left, `is_rest`, those of
/// `mien run`). `study`: how it is told in commands, "my.yaml --out o".
TroubleWords words_of_end(const ElementEnd& end, bool is_rest, const std::string& study);

/// How Slurm ended a job that could not say why itself.
TroubleWords words_of_state(const QueueRow& row, const std::string& study);

/// Why Slurm keeps a job that nobody's exit code accounts for.
TroubleWords words_of_hold(const QueueRow& row, const std::string& study);

/// Of jobs of the study as it was before it was edited.
TroubleWords words_of_edit(const std::string& study);

}  // namespace mien::pipeline
