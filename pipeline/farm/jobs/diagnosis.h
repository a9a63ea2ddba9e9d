#pragma once

#include <string>

#include "pipeline/farm/jobs/job_status.h"
#include "pipeline/farm/slurm/slurm_output.h"

namespace mien::pipeline {

/// Why a job has ended or is held ("held by the user"), and the remedy.
struct Diagnosis {
  std::string cause;
  std::string remedy;
};

/// Cause and remedy for the recorded exit code of a job: that of its worker, or that of `mien run`
/// for the job that completes a submission (`is_rest`). `study`: the study's arguments in commands,
/// "my.yaml --out o".
Diagnosis diagnose_exit(const ElementExit& end, bool is_rest, const std::string& study);

/// Cause for a job that recorded no exit code, or that Slurm ended (memory, time limit, node
/// failure). `study`: as above.
Diagnosis diagnose_state(const QueueRow& row, const std::string& study);

/// Cause for a job that Slurm holds, if no exit code explains it. `study`: as above.
Diagnosis diagnose_hold(const QueueRow& row, const std::string& study);

/// Cause for jobs submitted for an earlier state of the study: an earlier manifest, version of
/// mien, quality or kind of processor. `study`: as above.
Diagnosis diagnose_edit(const std::string& study);

}  // namespace mien::pipeline
