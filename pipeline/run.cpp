#include "pipeline/run.h"

#include <algorithm>

#include "pipeline/files.h"
#include "pipeline/provenance.h"

namespace mien::pipeline {

namespace {

void put_provenance(const Production& production, const RunResult& result, Store& store) {
  const std::string text = provenance(production.manifest(), result.outcomes);
  const Hash key = hash_of(text);
  if (store.find("provenance.json", key)) return;
  store.put(
      "provenance.json", key, [&](const std::filesystem::path& file) { write_file(file, text); },
      [](const std::filesystem::path&) {});
}

}  // namespace

int RunResult::count(TaskState state) const {
  return static_cast<int>(std::count_if(outcomes.begin(), outcomes.end(), [&](const auto& outcome) {
    return outcome.state == state;
  }));
}

bool RunResult::is_complete() const {
  return count(TaskState::cached) + count(TaskState::made) == static_cast<int>(outcomes.size());
}

RunResult run(Production& production, const std::filesystem::path& folder, int jobs,
              const std::stop_token& stop, const RunObserver& observer) {
  Store store(folder);
  RunResult result;
  result.outcomes = run(production.graph(), store, jobs, stop, observer);
  result.was_interrupted = stop.stop_requested() && !result.is_complete();
  if (production.is_whole() && result.is_complete()) put_provenance(production, result, store);
  result.nondeterminism = store.nondeterminism();
  return result;
}

}  // namespace mien::pipeline
