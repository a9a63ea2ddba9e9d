#include "pipeline/production/run/run.h"

#include <algorithm>

#include <fmt/format.h>

#include "motion/error.h"
#include "motion/text/excerpt.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/people.h"
#include "pipeline/manifest/repetitions.h"
#include "pipeline/production/film/film_record.h"
#include "pipeline/production/film/film_tables.h"
#include "pipeline/production/run/provenance.h"
#include "pipeline/production/run/study_inputs.h"
#include "pipeline/production/synthesis/motion_record.h"

namespace mien::pipeline {

namespace {

constexpr const char* provenance_path = "provenance.json";

void put_provenance(const Production& production, const RunResult& result, Store& store) {
  const std::string text = provenance(production.manifest(), result.outcomes);
  const Hash key = hash_of(text);
  if (store.find(provenance_path, key)) return;
  store.put(
      provenance_path, key, [&](const std::filesystem::path& file) { write_file(file, text); },
      [](const std::filesystem::path&) {});
}

/// Warnings about motions and films from their records, so that a run that finds everything made
/// reports them too.
std::vector<std::string> warnings_in(const Production& production, const RunResult& result,
                                     const Store& store) {
  std::vector<std::pair<std::string, std::string>> said;
  for (const Stimulus* motion : motion_sources(production.manifest())) {
    const std::size_t task = production.graph().index_of("motion:" + motion->id);
    if (result.outcomes[task].products.empty()) continue;
    const Receipt& record = result.outcomes[task].products.front();
    for (const std::string& warning :
         parse_motion_record(read_file(store.folder() / record.path)).warnings) {
      said.emplace_back(motion->id, warning);
    }
  }
  const std::vector<Task>& tasks = production.graph().tasks;
  for (std::size_t task = 0; task < tasks.size(); ++task) {
    if (tasks[task].kind != "film" || result.outcomes[task].products.empty()) continue;
    const std::string film = tasks[task].id.substr(tasks[task].id.find(':') + 1);
    const std::string record = read_file(store.folder() / film_record_path(film));
    for (const std::string& warning : parse_film_record(record).warnings) {
      said.emplace_back(film, warning);
    }
  }
  std::vector<std::string> warnings = repetition_warnings(production.manifest());
  for (std::string& warning : grouped_warnings(said)) warnings.push_back(std::move(warning));
  return warnings;
}

/// Two runs of a manifest that was edited in between write to the same paths: the later artifact
/// stays, and what was made of the other one no longer fits it.
void refuse_replaced(const RunResult& result, const Store& store) {
  for (const TaskOutcome& outcome : result.outcomes) {
    for (const Receipt& product : outcome.products) {
      const auto now = read_receipt(store.folder(), product.path);
      if (now && now->key == product.key) continue;
      throw Error(product.path + " was replaced by another process during this run",
                  "perhaps another run of a changed manifest is in progress; when it has finished, "
                  "run the same command again to continue");
    }
  }
}

constexpr std::size_t most_names_listed = 6;

}  // namespace

int RunResult::count(TaskState state) const {
  return static_cast<int>(std::count_if(outcomes.begin(), outcomes.end(), [&](const auto& outcome) {
    return outcome.state == state;
  }));
}

bool RunResult::is_complete() const {
  return count(TaskState::cached) + count(TaskState::made) == static_cast<int>(outcomes.size());
}

std::string counted_tasks(const RunResult& result) {
  const int made = result.count(TaskState::made);
  const int cached = result.count(TaskState::cached);
  const int failed = result.count(TaskState::failed);
  if (result.is_complete() && made == 0)
    return fmt::format("nothing to do, all {} tasks are done", cached);
  std::string text = fmt::format("{} {} done", made, made == 1 ? "task" : "tasks");
  if (cached > 0) text += fmt::format(", {} up to date", cached);
  if (failed > 0) text += fmt::format(", {} failed", failed);
  const int left = static_cast<int>(result.outcomes.size()) - made - cached - failed;
  if (result.was_interrupted)
    return text +
           fmt::format(", {} left; interrupted: run the same command again to continue", left);
  return left > 0 ? text + fmt::format(", {} skipped because they depend on it", left) : text;
}

std::vector<Receipt> stale_in(const std::filesystem::path& folder, const Production& production) {
  if (!production.is_whole()) return {};
  std::vector<std::string> kept = {provenance_path};
  for (const auto& [path, hash] : production.inputs()) kept.push_back(path);
  kept.emplace_back(as_run_path);
  return stale_artifacts(folder, production.graph(), kept);
}

RunResult run(Production& production, const std::filesystem::path& folder, int jobs,
              const std::stop_token& stop, const RunObserver& observer, Sharing sharing) {
  Store store(folder, sharing);
  RunResult result;
  result.outcomes = run(production.graph(), store, jobs, stop, observer);
  result.was_interrupted = stop.stop_requested() && !result.is_complete();
  if (production.is_whole() && result.is_complete()) {
    refuse_replaced(result, store);
    put_inputs(production.manifest(), production.inputs(), store);
    put_provenance(production, result, store);
    store.remove_intermediates();
  }
  result.warnings = warnings_in(production, result, store);
  result.nondeterminism = store.nondeterminism();
  result.repairs = store.repairs();
  return result;
}

bool is_recorded(const Production& production, const std::vector<TaskOutcome>& outcomes,
                 const std::filesystem::path& folder) {
  const Hash key = hash_of(provenance(production.manifest(), outcomes));
  return find_artifact(folder, provenance_path, key).has_value();
}

std::vector<std::string> grouped_warnings(
    const std::vector<std::pair<std::string, std::string>>& said) {
  std::vector<std::pair<std::string, std::vector<std::string>>> groups;
  for (const auto& [name, warning] : said) {
    auto group = std::ranges::find(groups, warning, [](const auto& one) { return one.first; });
    if (group == groups.end()) group = groups.insert(groups.end(), {warning, {}});
    if (std::ranges::find(group->second, name) == group->second.end())
      group->second.push_back(name);
  }
  std::vector<std::string> lines;
  for (const auto& [warning, names] : groups)
    lines.push_back(motion::first_of(names, most_names_listed) + ": " + warning);
  return lines;
}

}  // namespace mien::pipeline
