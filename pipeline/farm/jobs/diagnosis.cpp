#include "pipeline/farm/jobs/diagnosis.h"

#include <csignal>
#include <cstring>

#include <fmt/format.h>

#include "pipeline/farm/slurm/worker_codes.h"

namespace mien::pipeline {

namespace {

std::string resume(const std::string& study) { return "mien farm resume " + study; }

std::string submit(const std::string& study) { return resume(study) + " submits what is missing"; }

std::string fix_then_resume(const std::string& study) {
  return "mien farm logs " + study + " shows the error; fix it, then " + resume(study);
}

std::string inspect_and_submit(const std::string& study) {
  return "mien farm logs " + study + " shows details; " + submit(study);
}

std::string restore_folder(const std::string& study) {
  return "free space in it or restore it, then " + submit(study);
}

/// For a job that should have recorded how it ended, but has not.
Diagnosis diagnose_missing_record(const std::string& what, const std::string& study) {
  return {what +
              " without a recorded reason, as when the study's folder is full, read-only or "
              "unavailable",
          restore_folder(study)};
}

Diagnosis diagnose_out_of_memory(const std::string& study) {
  return {
      "out of memory",
      resume(study) +
          " requests twice the memory if --mem was given before, or the amount given with --mem"};
}

/// The equivalent exit code of a worker; `mien run` has other codes.
int worker_code(int code, bool is_rest) {
  if (!is_rest) return code;
  if (code == 130) return worker_transient;
  return code == 2 ? worker_bad_input : code;
}

Diagnosis signal_cause(const ElementExit& end, const std::string& study) {
  const int code = end.code;
  if (end.out_of_memory) return diagnose_out_of_memory(study);
  if (code == worker_killed) {
    return {fmt::format("killed from outside (exit code {}, SIGKILL)", code),
            inspect_and_submit(study)};
  }
  return {fmt::format("crashed (exit code {}: {})", code, ::strsignal(code - 128)),
          inspect_and_submit(study)};
}

}  // namespace

Diagnosis diagnose_exit(const ElementExit& end, bool is_rest, const std::string& study) {
  switch (worker_code(end.code, is_rest)) {
    case worker_bad_input:
      return {fmt::format("bad input, not retried (exit code {})", worker_bad_input),
              fix_then_resume(study)};
    case worker_transient:
      if (end.restarts < most_restarts) return {"stopped before completion", submit(study)};
      return {fmt::format("stopped, or failed because of the machine, {} times (exit code {})",
                          end.restarts + 1, worker_gave_up),
              inspect_and_submit(study)};
    case worker_disk_unavailable:
      return {fmt::format("gave up waiting for the study's folder, which was full, read-only or "
                          "unavailable (exit code {})",
                          worker_disk_unavailable),
              restore_folder(study)};
    case worker_gave_up:
      return {fmt::format("failed (exit code {})", worker_gave_up), inspect_and_submit(study)};
    case worker_wrong_setup:
      return {fmt::format("wrong configuration: manifest or list missing, or a different version "
                          "of mien or kind of processor than at submission (exit code {})",
                          worker_wrong_setup),
              fix_then_resume(study)};
    case 126:
    case 127:
      return {fmt::format("mien could not be started on the node (exit code {})", end.code),
              fix_then_resume(study)};
    default:
      if (end.code > 128 && end.code < 128 + NSIG) return signal_cause(end, study);
      return {fmt::format("failed (exit code {})", end.code), inspect_and_submit(study)};
  }
}

Diagnosis diagnose_state(const QueueRow& row, const std::string& study) {
  if (row.state == "OUT_OF_MEMORY") return diagnose_out_of_memory(study);
  if (row.state == "TIMEOUT" || row.state == "DEADLINE")
    return {"time limit reached", submit(study) + ", with --time 4:00:00 for longer"};
  if (row.state == "NODE_FAIL" || row.state == "BOOT_FAIL") return {"node failure", submit(study)};
  if (row.state == "PREEMPTED") return {"preempted", submit(study)};
  if (row.reason == "NonZeroExitCode") return diagnose_missing_record("ended on its own", study);
  return {"killed or not started, without an error message (" + row.reason + ")",
          inspect_and_submit(study)};
}

Diagnosis diagnose_hold(const QueueRow& row, const std::string& study) {
  const std::string& reason = row.reason;
  if (exceeds_partition(row)) {
    return {"no node of the partition satisfies the request (" + reason + ")",
            resume(study) +
                " --jobs 1, or with another --mem, --time or --partition, submits it again; sinfo "
                "-N -l lists the nodes' resources"};
  }
  if (reason == "DependencyNeverSatisfied")
    return {"waiting for a job that did not end as required", submit(study)};
  if (reason.starts_with("launch")) return {"could not be started on the node", submit(study)};
  if (reason == "JobHeldAdmin")
    return {"held by an administrator", "ask the administrator, who alone can release it"};
  if (row.state == "PENDING") {
    return {"held by the user",
            "scontrol release releases it; " + resume(study) + " submits it again"};
  }
  if (row.state == "SPECIAL_EXIT") return diagnose_missing_record("put itself on hold", study);
  return {"ended abnormally", fix_then_resume(study)};
}

Diagnosis diagnose_edit(const std::string& study) {
  return {
      "the manifest was edited after submission, or mien, --quality or the kind of processor has "
      "changed",
      resume(study) + " cancels the jobs and submits the study as it is now"};
}

}  // namespace mien::pipeline
