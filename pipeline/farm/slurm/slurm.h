#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "pipeline/farm/slurm/slurm_answers.h"
#include "pipeline/tasks/command_run.h"

namespace mien::pipeline {

/// Slurm is not installed, its controller does not answer, or it refused something. `what()` has
/// Slurm's own words and what to do.
class SlurmFault : public std::runtime_error {
 public:
  using runtime_error::runtime_error;
};

/// Slurm answers, but takes no job now, and sbatch still tried when its time was up.
class SlurmIsFull : public SlurmFault {
 public:
  using SlurmFault::SlurmFault;
};

/// Nothing is known of what became of a request: the answer did not come.
class SlurmSilence : public SlurmFault {
 public:
  using SlurmFault::SlurmFault;
};

/// Slurm's commands. Each waits for a limited time and throws SlurmFault when it fails.
class Slurm {
 public:
  explicit Slurm(std::chrono::milliseconds limit = std::chrono::seconds(60)) : limit_(limit) {}

  /// What the site allows.
  SlurmSite site() const;

  /// Partitions and nodes; nothing where sinfo tells none.
  std::vector<NodeShape> nodes() const;

  /// How each node is; nothing where sinfo does not tell.
  NodeStates node_states() const;

  /// Jobs of everybody, those that ended a short time ago too; an element of an array a row.
  std::vector<QueueRow> queue() const;

  /// The same, or nothing where Slurm is not installed or does not answer; `why` says it then.
  std::optional<std::vector<QueueRow>> queue_if_any(std::string& why) const;

  /// Submits a batch file to run after all of these jobs have ended, however they did, and gives
  /// its job. Throws SlurmIsFull when it was refused again and again, and SlurmSilence when it may
  /// have been submitted or not.
  std::string submit(const std::filesystem::path& script, const std::vector<std::string>& after,
                     const std::vector<std::string>& more = {}) const;

  void cancel(const std::vector<std::string>& jobs) const;

 private:
  CommandEnd run(const std::vector<std::string>& words) const;

  std::chrono::milliseconds limit_;
};

/// Why a command of Slurm failed, and what to do about it; Slurm's own words stand last.
std::string slurm_fault(const std::string& program, const CommandEnd& end);

}  // namespace mien::pipeline
