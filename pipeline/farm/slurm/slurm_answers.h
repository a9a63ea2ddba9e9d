#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mien::pipeline {

/// One job, or one element of a job array, as squeue tells it.
struct QueueRow {
  std::string job;           ///< "17": what scancel takes
  std::string array;         ///< "12": the array's job, or the job itself
  std::optional<int> index;  ///< in its array
  std::string state;         ///< "RUNNING"
  std::string reason;        ///< "Priority"; why it waits or how it failed
  std::string node;          ///< empty while it waits
  std::string elapsed;       ///< "1:05"
  std::string comment;       ///< what it was submitted with

  friend bool operator==(const QueueRow&, const QueueRow&) = default;
};

/// The format of squeue (-o) that `queue_rows` reads. The comment, in which people may write
/// anything, stands last.
inline constexpr const char* queue_format = "%A|%F|%K|%T|%r|%N|%M|%k";

/// The rows of `squeue -h -r -o <queue_format>`; lines that are none are left out.
std::vector<QueueRow> queue_rows(std::string_view text);

/// Whether a job waits, runs or is about to do so again.
bool is_live(const QueueRow& row);

/// Whether a job that waits will never run by itself: somebody has to look at it.
bool is_stuck(const QueueRow& row);

/// Whether a job that waits or runs will go on by itself: one that is about to end makes nothing
/// more.
bool goes_on(const QueueRow& row);

/// Whether a job that waits asks for what its partition does not have.
bool asks_too_much(const QueueRow& row);

/// Seconds that it runs, or did; 0 where Slurm does not tell.
double seconds_run(const QueueRow& row);

/// What Slurm says of each node: "idle", "allocated*" (it does not answer), "drained".
using NodeStates = std::map<std::string, std::string>;

/// The format of `sinfo -N` (-o) that `node_states` reads.
inline constexpr const char* node_state_format = "%N|%T";

/// The rows of `sinfo -h -N -o <node_state_format>`; lines that are none are left out.
NodeStates node_states(std::string_view text);

/// A partition on a node, and the processors that it has there.
struct NodeShape {
  std::string partition;
  bool is_default = false;
  int processors = 0;
};

/// The format of `sinfo -N` (-o) that `node_shapes` reads.
inline constexpr const char* node_format = "%P|%c";

/// The rows of `sinfo -h -N -o <node_format>`; lines that are none are left out.
std::vector<NodeShape> node_shapes(std::string_view text);

/// The most processors that a node of these partitions ("long,main") has, or of the one that jobs
/// get which name none; nothing where that is not known.
std::optional<int> most_processors(const std::vector<NodeShape>& nodes,
                                   const std::string& partitions);

/// What counts about a site's configuration.
struct SlurmSite {
  int max_array_size = 1001;        ///< indices of an array are below it
  bool requeues_transient = false;  ///< exit code 75 puts a job back into the queue
  bool holds_wrong_setup = false;   ///< exit code 78 does too, and holds it there
  int max_job_count = 0;            ///< jobs that it takes at a time, one more; 0: not told
};

/// From `scontrol show config`.
SlurmSite site_told(std::string_view text);

}  // namespace mien::pipeline
