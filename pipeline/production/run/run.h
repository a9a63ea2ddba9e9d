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
  std::vector<TaskOutcome> outcomes;  ///< one per task of the production's graph
  std::vector<Nondeterminism> nondeterminism;
  std::vector<std::string> repairs;   ///< repaired damage, as sentences
  std::vector<std::string> warnings;  ///< about design, motions and films: "guess-1: …"
  bool was_interrupted = false;

  int count(TaskState state) const;
  bool is_complete() const;  ///< every task was cached or completed
};

/// Returns the summary of a run for its last line: "7 tasks done, 2 up to date, 1 failed, 3 skipped
/// because they depend on it". For an interrupted run, it includes the number of remaining tasks.
/// If every task was up to date: "nothing to do, all 9 tasks are done".
std::string counted_tasks(const RunResult& result);

/// Returns the artifacts in `folder` that the manifest no longer makes. Empty for a production of
/// selected stimuli, because artifacts of the others are not stale.
std::vector<Receipt> stale_in(const std::filesystem::path& folder, const Production& production);

/// Makes the artifacts that are missing from `folder`. Concurrent runs of the study in the same
/// folder share the work. For a whole production, writes provenance.json and inputs/ once
/// everything is complete. Throws StoreBusy if another process uses the folder and one of the two
/// requires exclusive access, and Error if a run of a different version of the study replaced
/// artifacts, or an input was changed, in the meantime.
RunResult run(Production& production, const std::filesystem::path& folder, int jobs,
              const std::stop_token& stop, const RunObserver& observer,
              Sharing sharing = Sharing::shared);

/// Whether the study's record, provenance.json, is of its present state: of the manifest, its
/// inputs and these artifacts. `outcomes`: one per task of the whole production, all of them
/// complete.
bool is_recorded(const Production& production, const std::vector<TaskOutcome>& outcomes,
                 const std::filesystem::path& folder);

/// Returns one line per warning, with the names of the stimuli that it concerns: "sad-walk,
/// happy-walk, … and 41 more: the left foot slides". `said` holds pairs of a name and a warning;
/// lines are in the order of the warnings' first occurrence.
std::vector<std::string> grouped_warnings(
    const std::vector<std::pair<std::string, std::string>>& said);

}  // namespace mien::pipeline
