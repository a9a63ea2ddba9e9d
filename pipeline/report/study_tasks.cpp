#include "pipeline/report/study_tasks.h"

#include <stdexcept>
#include <utility>

#include "pipeline/documents/csv.h"
#include "pipeline/documents/files.h"
#include "pipeline/manifest/artifact_keys.h"
#include "pipeline/report/foils.h"
#include "pipeline/report/report.h"
#include "pipeline/report/tables.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr double tables_cost_seconds = 0.05;
constexpr double report_cost_seconds = 0.01;

using Table = std::pair<const char*, std::string (*)(const Manifest&, Motions&)>;

constexpr Table tables[] = {{"distances", distances_csv},
                            {"joint_distances", joint_distances_csv},
                            {"weights", weights_csv},
                            {"clips", clips_csv},
                            {"parameters", parameters_csv},
                            {"impressions", impressions_csv},
                            {"findings", findings_csv},
                            {"feature_changes", feature_changes_csv},
                            {"foils", foils_csv}};

/// The manifest's own text: ids, roles and comparisons are all told in tables and report.
void add_study(KeyBuilder& key, const Manifest& manifest, const SharedDeterminants& shared) {
  key.add("libraries", shared.libraries).add("repertoire", shared.repertoire);
  key.add("motion", motion_code()).add("pipeline", pipeline_code());
  key.add("film", film_code());
  add_file(key, manifest.file);
  for (const Stimulus& stimulus : manifest.stimuli) {
    add_motion(key, stimulus);
    add_film(key, stimulus);
  }
}

}  // namespace

Task tables_task(const Manifest& manifest, Motions& motions, const SharedDeterminants& shared) {
  Task task;
  task.id = "tables";
  task.kind = "tables";
  add_study(task.determinants, manifest, shared);
  for (const Stimulus& stimulus : manifest.stimuli) task.inputs.push_back("motion:" + stimulus.id);
  for (const auto& [name, make] : tables) {
    task.products.push_back({std::string("metrics/") + name + ".csv", {}});
  }
  task.cost_seconds = tables_cost_seconds;
  task.make = [&manifest, &motions](TaskRun& run) {
    for (std::size_t i = 0; i < run.keys.size(); ++i) {
      const std::string text = tables[i].second(manifest, motions);
      run.store.put(
          run.task.products[i].path, run.keys[i],
          [&](const fs::path& file) { write_file(file, text); },
          [](const fs::path& file) { read_csv(file); });
    }
  };
  return task;
}

Task report_task(const Manifest& manifest, Motions& motions, const SharedDeterminants& shared,
                 const TaskGraph& graph) {
  Task task;
  task.id = "report";
  task.kind = "report";
  add_study(task.determinants, manifest, shared);
  for (const Task& other : graph.tasks) task.inputs.push_back(other.id);
  task.products = {{"report.html", {}}};
  task.cost_seconds = report_cost_seconds;
  task.make = [&manifest, &motions](TaskRun& run) {
    const std::string page = report(manifest, motions);
    run.store.put(
        run.task.products[0].path, run.keys[0],
        [&](const fs::path& file) { write_file(file, page); },
        [](const fs::path& file) {
          if (!read_file(file).ends_with("</html>\n")) {
            throw std::runtime_error(file.string() + " is no complete page");
          }
        });
  };
  return task;
}

}  // namespace mien::pipeline
