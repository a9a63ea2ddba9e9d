#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "end_to_end/program.h"

namespace mien::test {

/// A Slurm cluster of two nodes, "n1" and "n2", of one processor each, on this machine: controller,
/// daemons and authentication of its own in a folder of its own, as whoever runs the tests. Nothing
/// of the system's own Slurm, if it has one, is touched. While the object lives, SLURM_CONF makes
/// Slurm's commands mean this cluster. All of its processes end with it, however a test ends.
class SlurmCluster {
 public:
  /// Who puts jobs back into the queue that ended with 75 and holds those that ended with 78.
  enum class Requeue { by_site, by_job };

  /// Why there can be none here; empty when there can.
  static std::string obstacle();

  /// Throws std::runtime_error, with what the daemons said, when it does not come up.
  explicit SlurmCluster(Requeue requeue = Requeue::by_site);
  ~SlurmCluster();
  SlurmCluster(const SlurmCluster&) = delete;
  SlurmCluster& operator=(const SlurmCluster&) = delete;

  const std::filesystem::path& folder() const { return scratch_.path(); }

  /// SIGKILL to a node's daemon (1 or 2); what it had begun runs on.
  void kill_node(int node) const;
  void restart_node(int node) const;

  /// SIGKILL to every job and to the processes that watch over them.
  void kill_steps() const;

  void kill_controller() const;
  /// `forgets`: it knows of no job any more, and counts them from 1 again.
  void start_controller(bool forgets) const;

  /// Rows "job|index|state|reason|node|comment" of all jobs, those that ended a short time ago too.
  std::vector<std::string> queue() const;

  /// Waits until no job waits or runs. False after so many seconds.
  bool wait_until_empty(double seconds) const;

 private:
  void write_configuration(Requeue requeue) const;
  void start();
  void stop() const;

  Scratch scratch_;
  int port_ = 0;  ///< of the controller; the nodes have the next two
};

/// Asks every fifth of a second until it holds. False after so many seconds.
bool wait_until(double seconds, const std::function<bool()>& holds);

}  // namespace mien::test
