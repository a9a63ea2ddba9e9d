#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// Where everything comes from, as JSON: versions, the command line, the seed, all settings of
/// every stimulus, the hashes of the manifest, of its inputs and of every artifact. No dates, no
/// names of machines: the same production gives the same bytes. Together with the folder inputs/
/// beside it (study_inputs.h), `mien run provenance.json` makes the study again.
std::string provenance(const Manifest& manifest, const std::vector<TaskOutcome>& outcomes);

/// What has changed since a provenance.json was written, a sentence each: inputs of the manifest
/// that it was read as, the manifest that is run, and the program's version. Then what is made
/// again may differ.
std::vector<std::string> changes_since(const std::filesystem::path& provenance,
                                       const Manifest& manifest);

}  // namespace mien::pipeline
