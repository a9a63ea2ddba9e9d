#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// Where everything comes from, as JSON: versions, seed, the hashes of the manifest, of its inputs
/// and of every artifact. No dates, no names of machines: the same production gives the same bytes.
std::string provenance(const Manifest& manifest, const std::vector<TaskOutcome>& outcomes);

}  // namespace mien::pipeline
