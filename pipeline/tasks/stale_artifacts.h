#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/tasks/receipt.h"
#include "pipeline/tasks/store.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// Artifacts that were made in this folder once and that no task makes any more, by path: of a
/// stimulus that has another name now, or a video of a kind that is not asked for. Files without a
/// receipt are nobody's. `kept` are paths that belong to a study beside its tasks' products.
std::vector<Receipt> stale_artifacts(const std::filesystem::path& folder, const TaskGraph& graph,
                                     const std::vector<std::string>& kept);

/// Paths of those that a reader sees, not the store's own.
std::vector<std::string> shown_paths(const std::vector<Receipt>& artifacts);

/// Whether it is as it was made, or gone already.
bool is_removable(const std::filesystem::path& folder, const Receipt& artifact);

/// Removes an artifact with its receipt, and folders that are empty then. What has been changed
/// since it was made stays, and false is returned.
bool remove_artifact(const Store& store, const Receipt& artifact);

}  // namespace mien::pipeline
