#include "pipeline/production/run/run.h"

#include <map>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pipeline/commands/line/console.h"
#include "pipeline/commands/line/installed_manifests.h"
#include "pipeline/commands/line/production_options.h"
#include "pipeline/manifest/checks/document_checks.h"
#include "pipeline/production/run/provenance.h"
#include "pipeline/tasks/progress.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// Prints each error once, with the tasks that it stopped.
void print_faults(const TaskGraph& graph, const RunResult& result, const Console& console) {
  std::map<std::string, std::string> tasks_by_error;
  for (std::size_t i = 0; i < result.outcomes.size(); ++i) {
    if (result.outcomes[i].state != TaskState::failed) continue;
    std::string& tasks = tasks_by_error[result.outcomes[i].error];
    tasks += (tasks.empty() ? "" : ", ") + graph.tasks[i].id;
  }
  for (const auto& [error, tasks] : tasks_by_error)
    console.err << error << "\n  (" << tasks << ")\n";
  for (const std::string& warning : result.warnings) console.err << "warning: " << warning << '\n';
  for (const std::string& repair : result.repairs) console.err << "note: " << repair << '\n';
  for (const Nondeterminism& met : result.nondeterminism) console.err << to_string(met) << '\n';
}

void print_summary(const RunResult& result, const fs::path& folder, const Console& console) {
  console.out << folder.string() << ": " << counted_tasks(result) << '\n';
}

ordered_json tasks_in(const TaskGraph& graph, const RunResult& result, TaskState state) {
  ordered_json ids = ordered_json::array();
  for (std::size_t i = 0; i < result.outcomes.size(); ++i)
    if (result.outcomes[i].state == state) ids.push_back(graph.tasks[i].id);
  return ids;
}

void print_json(const Production& production, const RunResult& result, const fs::path& folder,
                const Console& console) {
  ordered_json failed = ordered_json::array();
  ordered_json artifacts = ordered_json::array();
  for (std::size_t i = 0; i < result.outcomes.size(); ++i) {
    const TaskOutcome& outcome = result.outcomes[i];
    if (outcome.state == TaskState::failed)
      failed.push_back({{"task", production.graph().tasks[i].id}, {"error", outcome.error}});
    for (const Receipt& product : outcome.products) {
      if (product.path.starts_with(".mien/")) continue;
      artifacts.push_back({{"path", product.path}, {"hash", product.hash}, {"size", product.size}});
    }
  }
  ordered_json differing = ordered_json::array();
  for (const Nondeterminism& met : result.nondeterminism) differing.push_back(met.path);
  const ordered_json summary = {{"study", production.manifest().study},
                                {"folder", folder.string()},
                                {"made", tasks_in(production.graph(), result, TaskState::made)},
                                {"cached", tasks_in(production.graph(), result, TaskState::cached)},
                                {"failed", failed},
                                {"interrupted", result.was_interrupted},
                                {"warnings", result.warnings},
                                {"repairs", result.repairs},
                                {"nondeterminism", differing},
                                {"artifacts", artifacts},
                                {"stale", shown_paths(stale_in(folder, production))}};
  console.out << summary.dump(2, ' ', false, ordered_json::error_handler_t::replace) << '\n';
}

int exit_code(const RunResult& result) {
  if (result.was_interrupted) return exit_interrupted;
  bool is_bad_input = false;
  for (const TaskOutcome& outcome : result.outcomes) {
    if (outcome.state != TaskState::failed) continue;
    if (!outcome.is_bad_input) return exit_failed;
    is_bad_input = true;
  }
  if (is_bad_input) return exit_bad_input;
  return result.nondeterminism.empty() ? exit_done : exit_failed;
}

void print_changes(const fs::path& file, const Manifest& manifest, const Console& console) {
  if (!study_record_in(file)) return;
  for (const std::string& change : changes_since(file, manifest))
    console.err << "warning: " << file.string() << ": " << change << '\n';
}

int run_production(const ProductionArguments& arguments, const Console& console) {
  const fs::path file = resolve_manifest(arguments.manifest, console);
  Production production(load_with_warnings(file, arguments.out, console), options_of(arguments));
  print_changes(file, production.manifest(), console);
  const fs::path folder = folder_of(arguments, production.manifest());
  RunResult result;
  {
    Progress progress(console.err, console.err_is_terminal, production.graph(),
                      quick_plan(production.graph(), folder), steady_seconds);
    result = run(production, folder, jobs_of(arguments), console.stop, progress.observer(),
                 arguments.exclusive ? Sharing::exclusive : Sharing::shared);
  }
  print_faults(production.graph(), result, console);
  if (arguments.json) {
    print_json(production, result, folder, console);
  } else {
    print_summary(result, folder, console);
    print_stale_artifacts(shown_paths(stale_in(folder, production)), arguments, console);
  }
  return exit_code(result);
}

}  // namespace

Command run_command() {
  const auto arguments = std::make_shared<ProductionArguments>();
  return {
      .name = "run",
      .summary = "Make everything that a manifest specifies",
      .options = all_of(production_options(*arguments),
                        flag("--exclusive", &arguments->exclusive,
                             "Refuse to run while another process works in the study's folder (by "
                             "default, both share the work)")),
      .notes =
          "Artifacts that are up to date are not made again; an interrupted run continues where it "
          "stopped.\n\n"
          "Examples:\n"
          "  mien run quickstart\n"
          "  mien run my.yaml --only target-1,guess-1 --quality draft",
      .run = [arguments](const Console& console) { return run_production(*arguments, console); }};
}

}  // namespace mien::pipeline
