#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "pipeline/farm/slurm/slurm_output.h"
#include "pipeline/tasks/command_run.h"

namespace mien::pipeline {

/// Thrown if Slurm is not installed, its controller does not answer, or it refused a request.
/// `what()` contains Slurm's message and, if known, a remedy.
class SlurmFault : public std::runtime_error {
 public:
  using runtime_error::runtime_error;
};

/// Thrown if Slurm accepts no jobs at present: sbatch was still retrying at the time limit.
class SlurmQueueFull : public SlurmFault {
 public:
  using SlurmFault::SlurmFault;
};

/// Thrown if Slurm did not answer a submission, so that it is unknown whether the job was accepted.
class SlurmTimeout : public SlurmFault {
 public:
  using SlurmFault::SlurmFault;
};

/// Slurm's commands. Unless stated otherwise, each throws SlurmFault if it fails or exceeds the
/// time limit.
class Slurm {
 public:
  explicit Slurm(std::chrono::milliseconds limit = std::chrono::seconds(60)) : limit_(limit) {}

  /// Whether this machine has Slurm's commands.
  bool is_installed() const;

  /// The site's limits and settings.
  SlurmSite site() const;

  /// Number of processors of each node in each partition; empty if sinfo fails.
  std::vector<NodeShape> nodes() const;

  /// State of each node; empty if sinfo fails.
  NodeStates node_states() const;

  /// Jobs of all users, including recently ended ones; one row per element of an array.
  std::vector<QueueRow> queue() const;

  /// Like queue(), but returns nullopt instead of throwing, and sets `why` to the reason.
  std::optional<std::vector<QueueRow>> queue_if_any(std::string& why) const;

  /// Submits a batch file and returns its job ID. The job starts after all jobs in `after` have
  /// ended, successfully or not. `more`: additional options of sbatch. Throws SlurmQueueFull if
  /// Slurm refused the job until the time limit, and SlurmTimeout if it is unknown whether the job
  /// was submitted.
  std::string submit(const std::filesystem::path& script, const std::vector<std::string>& after,
                     const std::vector<std::string>& more = {}) const;

  /// Cancels jobs and elements; those that have ended already are ignored.
  void cancel(const std::vector<std::string>& jobs) const;

 private:
  CommandResult run(const std::vector<std::string>& words) const;

  std::chrono::milliseconds limit_;
};

/// The cause of a failed Slurm command and its remedy, as far as known, and Slurm's own message.
std::string slurm_fault(const std::string& program, const CommandResult& end);

}  // namespace mien::pipeline
