#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "end_to_end/program.h"

namespace mien::test {

/// A private Slurm cluster on this machine with two nodes, "n1" and "n2", of one processor each:
/// its own controller, daemons and authentication in its own folder, run by the user of the tests.
/// A system-wide Slurm is not affected. During the object's lifetime SLURM_CONF makes Slurm's
/// commands use this cluster. Its processes end with the object, also if a test crashes.
class SlurmCluster {
 public:
  /// Whether the site or the job requeues after exit code 75 and holds after 78.
  enum class Requeue { by_site, by_job };

  /// Why a cluster cannot run here; empty if it can.
  static std::string obstacle();

  /// Throws std::runtime_error with the daemons' output if the cluster does not start.
  explicit SlurmCluster(Requeue requeue = Requeue::by_site);
  ~SlurmCluster();
  SlurmCluster(const SlurmCluster&) = delete;
  SlurmCluster& operator=(const SlurmCluster&) = delete;

  const std::filesystem::path& folder() const { return scratch_.path(); }

  /// Sends SIGKILL to the daemon of node 1 or 2; its jobs continue.
  void kill_node(int node) const;
  void restart_node(int node) const;

  /// Sends SIGKILL to every job and its supervising processes.
  void kill_steps() const;

  void kill_controller() const;
  /// `forgets`: it has lost all jobs and numbers new ones from 1.
  void start_controller(bool forgets) const;

  /// Rows "job|index|state|reason|node|comment" of all jobs, including recently ended ones.
  std::vector<std::string> queue() const;

  /// Waits until no job is pending or running. Returns false after `seconds`.
  bool wait_until_empty(double seconds) const;

 private:
  void write_configuration(Requeue requeue) const;
  void start();
  void stop() const;

  Scratch scratch_;
  int port_ = 0;  ///< of the controller; the nodes have the next two
};

/// Checks a condition every fifth of a second until it holds. Returns false after `seconds`.
bool wait_until(double seconds, const std::function<bool()>& holds);

}  // namespace mien::test
