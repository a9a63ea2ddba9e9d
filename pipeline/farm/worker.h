#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "pipeline/production/run/production.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// The tasks of these items and all tasks that must precede them, in the order of the graph.
/// `graph` must outlive the result. Throws Error if the graph lacks a task, or an item is a chunk
/// of a task without parts.
TaskGraph graph_of_items(const TaskGraph& graph, const std::vector<std::string>& items);

/// An item that failed, or for which a task failed that must precede it.
struct FailedWork {
  std::string item;
  std::string error;
  int code = 0;  ///< worker_bad_input, worker_disk_unavailable, worker_transient or worker_gave_up
};

/// The result of a worker's run.
struct WorkResult {
  std::vector<FailedWork> failed;
  std::vector<std::string>
      repairs;  ///< about damaged artifacts and files set aside (Store::repairs)
  std::vector<Nondeterminism> nondeterminism;
  bool was_interrupted = false;

  /// The worker's exit code: see worker_codes.h.
  int code() const;
};

/// Runs items on `jobs` threads in the study's folder, which many processes may do at the same
/// time. `items`: the graph of the tasks that the items need (graph_of_items); `names`: the names
/// of the items. The failure of an item is recorded in a file (failure_path), with a command that
/// reproduces it: `command`, to which the item is added as --tasks. Success removes the file.
/// Throws the exceptions of Store.
WorkResult work(const TaskGraph& items, const std::vector<std::string>& names,
                const std::filesystem::path& folder, int jobs, const std::stop_token& stop,
                const RunObserver& observer, const std::string& command);

/// Path of an item's failure record: farm/failures/film_walk_3_12_.json
std::filesystem::path failure_path(const std::filesystem::path& folder, const std::string& item);

}  // namespace mien::pipeline
