#include "pipeline/report/study_tasks.h"

#include <stdexcept>
#include <utility>

#include "pipeline/documents/files.h"
#include "pipeline/manifest/artifact_keys.h"
#include "pipeline/ratings/impression_table.h"
#include "pipeline/report/foils.h"
#include "pipeline/report/report.h"
#include "pipeline/report/table_forms.h"
#include "pipeline/report/tables.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr double tables_cost_seconds = 0.05;
constexpr double report_cost_seconds = 0.01;

struct Table {
  const TableForm& form;
  std::string (*make)(const Manifest&, Motions&);
};

constexpr Table tables[] = {{distances_form, distances_csv},
                            {joint_distances_form, joint_distances_csv},
                            {weights_form, weights_csv},
                            {clips_form, clips_csv},
                            {parameters_form, parameters_csv},
                            {examples_form, examples_csv},
                            {impressions_form, impressions_csv},
                            {expectations_form, expectations_csv},
                            {findings_form, findings_csv},
                            {feature_changes_form, feature_changes_csv},
                            {foils_form, foils_csv}};

}  // namespace

void add_study(KeyBuilder& key, const Manifest& manifest, const SharedDeterminants& shared) {
  key.add("libraries", shared.libraries).add("repertoire", shared.repertoire);
  key.add("motion", motion_code()).add("pipeline", pipeline_code());
  key.add("film", film_code());
  add_file(key, manifest.file);
  key.add("command", manifest.command);
  add_page(key, manifest);
  for (const Stimulus& stimulus : manifest.stimuli) {
    add_motion(key, stimulus);
    add_film(key, stimulus);
  }
  for (const Overlay& overlay : manifest.overlays) add_film(key, overlay.film);
}

std::vector<TableForm> study_table_forms() {
  std::vector<TableForm> forms;
  for (const Table& table : tables) forms.push_back(table.form);
  return forms;
}

Task tables_task(const Manifest& manifest, Motions& motions, const SharedDeterminants& shared) {
  Task task;
  task.id = "tables";
  task.kind = "tables";
  add_study(task.determinants, manifest, shared);
  for (const Stimulus& stimulus : manifest.stimuli) task.inputs.push_back("motion:" + stimulus.id);
  for (const Table& table : tables) task.products.push_back({std::string(table.form.path), {}});
  task.cost_seconds = tables_cost_seconds;
  task.make = [&manifest, &motions](TaskRun& run) {
    for (std::size_t i = 0; i < run.keys.size(); ++i) {
      const std::string text = tables[i].make(manifest, motions);
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
  task.products = {{"report.html", {}}, {"methods.md", {}}, {"references.bib", {}}};
  task.cost_seconds = report_cost_seconds;
  task.make = [&manifest, &motions](TaskRun& run) {
    const Methods methods = methods_of(manifest, motions);
    const std::string texts[] = {report(manifest, motions, methods), methods.markdown,
                                 methods.bibtex};
    for (std::size_t i = 0; i < run.keys.size(); ++i) {
      run.store.put(
          run.task.products[i].path, run.keys[i],
          [&](const fs::path& file) { write_file(file, texts[i]); },
          [&](const fs::path& file) {
            if (read_file(file) != texts[i])
              throw std::runtime_error(file.string() + " is not complete");
          });
    }
  };
  return task;
}

}  // namespace mien::pipeline
