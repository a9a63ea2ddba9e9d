#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

/// Returns the provenance of a study as JSON: versions, the command line, the seed, all settings of
/// every stimulus and overlay, and the hashes of the manifest, its inputs and all artifacts. It
/// contains no dates and no machine names: the same production gives the same bytes. With the
/// folder inputs/ next to it (study_inputs.h), `mien run provenance.json` reproduces the study.
std::string provenance(const Manifest& manifest, const std::vector<TaskOutcome>& outcomes);

/// Returns the changes since a provenance.json was written, one sentence each: in the program's
/// version, in the input files of `manifest`, and in inputs/as-run.yaml. `manifest` is the manifest
/// that the provenance records. If there are changes, reproduced artifacts may differ.
std::vector<std::string> changes_since(const std::filesystem::path& provenance,
                                       const Manifest& manifest);

}  // namespace mien::pipeline
