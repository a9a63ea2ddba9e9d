#include <memory>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pipeline/commands/line/console.h"
#include "pipeline/commands/line/installed_manifests.h"
#include "pipeline/commands/line/production_options.h"
#include "pipeline/manifest/repetitions.h"
#include "pipeline/manifest/stimulus_level.h"
#include "pipeline/production/run/run.h"
#include "pipeline/production/synthesis/parameter_request.h"
#include "pipeline/tasks/progress.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

std::string_view word_for(TaskState state) {
  return state == TaskState::cached ? "cached" : state == TaskState::due ? "due" : "waiting";
}

double cost_of(const TaskGraph& graph, const std::vector<TaskOutcome>& planned) {
  double cost = 0.0;
  for (std::size_t i = 0; i < planned.size(); ++i)
    if (planned[i].state != TaskState::cached) cost += graph.tasks[i].cost_seconds;
  return cost;
}

ordered_json as_json(const Task& task, const TaskOutcome& planned) {
  ordered_json products = ordered_json::array();
  for (const Product& product : task.products) products.push_back(product.path);
  return {{"id", task.id},         {"kind", task.kind},    {"state", word_for(planned.state)},
          {"inputs", task.inputs}, {"products", products}, {"cost_s", task.cost_seconds}};
}

ordered_json sentences(const std::vector<RequestedParameter>& requested) {
  ordered_json list = ordered_json::array();
  for (const RequestedParameter& parameter : requested) list.push_back(to_sentence(parameter));
  return list;
}

void show_json(const TaskGraph& graph, const std::vector<TaskOutcome>& planned,
               const Manifest& manifest, const std::string& folder,
               const std::vector<std::string>& stale, const Console& console) {
  ordered_json tasks = ordered_json::array();
  for (std::size_t i = 0; i < planned.size(); ++i)
    tasks.push_back(as_json(graph.tasks[i], planned[i]));
  const ordered_json result = {{"study", manifest.study},
                               {"folder", folder},
                               {"cost_s", cost_of(graph, planned)},
                               {"tasks", tasks},
                               {"levels", levels_made(manifest)},
                               {"adjectives", sentences(requested_parameters(manifest))},
                               {"warnings", repetition_warnings(manifest)},
                               {"stale", stale}};
  console.out << result.dump(2) << '\n';
}

void show_table(const TaskGraph& graph, const std::vector<TaskOutcome>& planned,
                const Manifest& manifest, const Console& console) {
  for (std::size_t i = 0; i < planned.size(); ++i) {
    const Task& task = graph.tasks[i];
    console.out << fmt::format("{:8}{:>9}  {}\n", word_for(planned[i].state),
                               as_duration(task.cost_seconds), task.id);
  }
  console.out << fmt::format("estimated time on one processor ([h:]min:s): {}\n",
                             as_duration(cost_of(graph, planned)));
  for (const std::string& levels : levels_made(manifest)) console.out << levels << '\n';
  console.out << feasibility_table(requested_parameters(manifest));
}

int show_plan(const ProductionArguments& arguments, const Console& console) {
  const std::filesystem::path file = resolve_manifest(arguments.manifest, console);
  const Production production(load_with_warnings(file, arguments.out, console),
                              options_of(arguments));
  const std::filesystem::path folder = folder_of(arguments, production.manifest());
  const std::vector<TaskOutcome> planned = quick_plan(production.graph(), folder);
  const std::vector<std::string> stale = shown_paths(stale_in(folder, production));
  if (arguments.json) {
    show_json(production.graph(), planned, production.manifest(), folder.string(), stale, console);
  } else {
    show_table(production.graph(), planned, production.manifest(), console);
    for (const std::string& warning : repetition_warnings(production.manifest()))
      console.err << "warning: " << warning << '\n';
    print_stale_artifacts(stale, arguments, console);
  }
  return exit_done;
}

}  // namespace

Command plan_command() {
  const auto arguments = std::make_shared<ProductionArguments>();
  return {.name = "plan",
          .summary = "Show what a run would make and how long it would take",
          .options = production_options(*arguments),
          .notes =
              "cached: up to date; due: will be made; waiting: depends on a task that is due. "
              "Three tasks write tables: \"tables\" writes the measurements of the motions, "
              "\"films\" those of the films, and \"design\" writes stimuli.csv, warnings.csv and "
              "the codebook. "
              "Files are checked by receipt and size only; mien run also reads their contents. "
              "Times are estimates.\n\nExample:\n  mien plan quickstart",
          .run = [arguments](const Console& console) { return show_plan(*arguments, console); }};
}

}  // namespace mien::pipeline
