#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// What `plan` tells, from a quick look: an artifact counts as there when its receipt has the right
/// key and a file (or a folder) of its name exists with the size stated. Nothing is hashed, so that
/// a study of thousands of films is looked through within a second or two; a file that was damaged
/// without changing its size is found by the next run, not here.
std::vector<TaskOutcome> glance(const TaskGraph& graph, const std::filesystem::path& folder);

}  // namespace mien::pipeline
