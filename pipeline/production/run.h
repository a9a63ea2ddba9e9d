#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "pipeline/production/production.h"
#include "pipeline/tasks/progress.h"
#include "pipeline/tasks/stale.h"
#include "pipeline/tasks/store.h"

namespace mien::pipeline {

/// How a run ended.
struct RunResult {
  std::vector<TaskOutcome> outcomes;  ///< one a task of the production's graph
  std::vector<Nondeterminism> nondeterminism;
  std::vector<std::string> warnings;  ///< about design, motions, films: "guess-1: …"
  bool was_interrupted = false;

  int count(TaskState state) const;
  bool is_complete() const;  ///< every task was cached or made
};

/// Artifacts in `folder` that the manifest no longer makes. Nothing of a production of some stimuli
/// only: the others are no less wanted.
std::vector<Receipt> stale_in(const std::filesystem::path& folder, const Production& production);

/// Makes what is not in `folder` yet, and writes provenance.json and inputs/ when everything is
/// there. Throws
/// StoreBusy when another run works in the folder.
RunResult run(Production& production, const std::filesystem::path& folder, int jobs,
              const std::stop_token& stop, const RunObserver& observer);

}  // namespace mien::pipeline
