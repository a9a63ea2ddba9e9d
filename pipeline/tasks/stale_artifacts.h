#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/tasks/receipt.h"
#include "pipeline/tasks/store.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// Artifacts in this folder that no task of the graph produces, sorted by path: for example those
/// of a renamed stimulus or of a video format that is no longer selected. Files without a receipt
/// are ignored. `kept`: paths that belong to the study in addition to its tasks' products.
std::vector<Receipt> stale_artifacts(const std::filesystem::path& folder, const TaskGraph& graph,
                                     const std::vector<std::string>& kept);

/// Paths of these artifacts, except those in the store's internal folder.
std::vector<std::string> shown_paths(const std::vector<Receipt>& artifacts);

/// Whether an artifact is unchanged since it was published, or no longer exists.
bool is_removable(const std::filesystem::path& folder, const Receipt& artifact);

/// Removes an artifact with its receipt, and folders that are empty afterwards. Returns false,
/// without removing it, if the artifact was changed.
bool remove_artifact(const Store& store, const Receipt& artifact);

}  // namespace mien::pipeline
