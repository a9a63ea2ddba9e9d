#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mien::pipeline {

/// One job, or one element of a job array, as listed by squeue.
struct QueueRow {
  std::string job;           ///< Slurm's job ID: "17"
  std::string array;         ///< ID of the array's job, or of the job itself: "12"
  std::optional<int> index;  ///< index within the array; empty if there is none
  std::string state;         ///< "RUNNING"
  std::string reason;        ///< why the job is pending or how it failed: "Priority"
  std::string node;          ///< empty while the job is pending
  std::string elapsed;       ///< run time: "1:05"
  std::string comment;       ///< given on submission

  friend bool operator==(const QueueRow&, const QueueRow&) = default;
};

/// The format of squeue (-o) that `queue_rows` reads. The comment is last, since it may contain any
/// character.
inline constexpr const char* queue_format = "%A|%F|%K|%T|%r|%N|%M|%k";

/// The rows of `squeue -h -r -o <queue_format>`; other lines are ignored.
std::vector<QueueRow> queue_rows(std::string_view text);

/// Whether a job has not ended: it is pending, held, running, suspended, completing or being
/// requeued.
bool is_live(const QueueRow& row);

/// Whether a job is held, or pending for a reason that will not pass, so that it never runs without
/// intervention.
bool is_stuck(const QueueRow& row);

/// Whether a pending or running job will proceed without intervention. False for a completing job,
/// since it produces nothing more.
bool will_proceed(const QueueRow& row);

/// Whether a pending job requests more than its partition has or allows.
bool exceeds_partition(const QueueRow& row);

/// Run time so far, seconds; 0 if squeue reports none.
double seconds_run(const QueueRow& row);

/// State of each node by its name: "idle", "allocated*" (not responding), "drained".
using NodeStates = std::map<std::string, std::string>;

/// The format of `sinfo -N` (-o) that `node_states` reads.
inline constexpr const char* node_state_format = "%N|%T";

/// Node states from `sinfo -h -N -o <node_state_format>`; other lines are ignored.
NodeStates node_states(std::string_view text);

/// A node's number of processors in one of its partitions.
struct NodeShape {
  std::string partition;
  bool is_default = false;
  int processors = 0;
};

/// The format of `sinfo -N` (-o) that `node_shapes` reads.
inline constexpr const char* node_format = "%P|%c";

/// The rows of `sinfo -h -N -o <node_format>`; other lines are ignored.
std::vector<NodeShape> node_shapes(std::string_view text);

/// Largest number of processors of a node in these partitions ("long,main"), or in the default
/// partition if none is named; nullopt if unknown.
std::optional<int> most_processors(const std::vector<NodeShape>& nodes,
                                   const std::string& partitions);

/// The relevant settings of a site's Slurm configuration.
struct SlurmSite {
  int max_array_size = 1001;        ///< array indices are smaller than this
  bool requeues_transient = false;  ///< exit code 75 requeues a job
  bool holds_wrong_setup = false;   ///< exit code 78 requeues a job and holds it
  int max_job_count = 0;            ///< maximum number of jobs plus one; 0 if unknown
};

/// Reads the output of `scontrol show config`.
SlurmSite parse_site(std::string_view text);

}  // namespace mien::pipeline
