#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/production/run/production.h"
#include "pipeline/tasks/progress.h"
#include "pipeline/tasks/stale_artifacts.h"
#include "pipeline/tasks/store.h"

namespace mien::pipeline {

/// The result of a run.
struct RunResult {
  std::vector<TaskOutcome> outcomes;  ///< one a task of the production's graph
  std::vector<Nondeterminism> nondeterminism;
  std::vector<std::string> repairs;   ///< what was found damaged or in the way, and made good
  std::vector<std::string> warnings;  ///< about design, motions, films: "guess-1: …"
  bool was_interrupted = false;

  int count(TaskState state) const;
  bool is_complete() const;  ///< every task was cached or made
};

/// "7 tasks done, 2 up to date, 1 failed, 3 skipped because they depend on it": how a run ended, in
/// the words of its last line; of an interrupted one with all that is left to do.
std::string counted_tasks(const RunResult& result);

/// Artifacts in `folder` that the manifest no longer makes. Nothing of a production of some stimuli
/// only: the others are no less wanted.
std::vector<Receipt> stale_in(const std::filesystem::path& folder, const Production& production);

/// Makes what is not in `folder` yet, together with other runs of the study that work there, and
/// writes provenance.json and inputs/ when everything is there. Throws StoreBusy when another
/// process works in the folder and it or this one is to be alone, and Error when a run of another
/// state of the study replaced artifacts in the meantime.
RunResult run(Production& production, const std::filesystem::path& folder, int jobs,
              const std::stop_token& stop, const RunObserver& observer,
              Sharing sharing = Sharing::shared);

/// One line per warning, with the names of the stimuli that it concerns: "sad-walk, happy-walk and
/// 41 more: the left foot slides". `said` holds pairs of a name and a warning; lines are in the
/// order in which warnings first occur.
std::vector<std::string> grouped_warnings(
    const std::vector<std::pair<std::string, std::string>>& said);

}  // namespace mien::pipeline
