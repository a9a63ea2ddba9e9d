#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "pipeline/production/run/production.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// The tasks that items ask for, and those whose products they read, in an order in which these
/// come first. `graph` outlives it. Throws Error when the graph has no such task, or it has no
/// parts.
TaskGraph graph_of_items(const TaskGraph& graph, const std::vector<std::string>& items);

/// An item that could not be made.
struct FailedWork {
  std::string item;
  std::string error;
  int code = 0;  ///< worker_bad_input, worker_no_disk, worker_transient or another
};

/// How a worker's work ended.
struct WorkResult {
  std::vector<FailedWork> failed;
  std::vector<std::string> repairs;  ///< what was found damaged and made good
  std::vector<Nondeterminism> nondeterminism;
  bool was_interrupted = false;

  /// The worker's exit code: see worker_codes.h.
  int code() const;
};

/// Makes items in the study's folder, as one process of many. A failed item leaves
/// farm/failures/<item>.json there, with `command`, which reproduces it; one that is made removes
/// it. Throws what Store throws.
WorkResult work(const TaskGraph& items, const std::vector<std::string>& names,
                const std::filesystem::path& folder, int jobs, const std::stop_token& stop,
                const RunObserver& observer, const std::string& command);

/// Where a failure is told: farm/failures/film_walk_3_12_.json
std::filesystem::path failure_path(const std::filesystem::path& folder, const std::string& item);

}  // namespace mien::pipeline
