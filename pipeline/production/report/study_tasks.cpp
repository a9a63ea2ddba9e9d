#include "pipeline/production/report/study_tasks.h"

#include <stdexcept>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/people.h"
#include "pipeline/production/report/report.h"
#include "pipeline/production/report/tables.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr double tables_cost_seconds = 0.05;
constexpr double report_cost_seconds = 0.01;

constexpr const StudyTable* tables[] = {
    &distances_table,  &joint_distances_table, &weights_table,     &clips_table,
    &parameters_table, &examples_table,        &impressions_table, &expectations_table,
    &findings_table,   &feature_changes_table, &foils_table,       &fits_table};

/// The tables of a study's tables task, in the order of its products.
std::vector<const StudyTable*> tables_of(const Manifest& manifest) {
  std::vector<const StudyTable*> made(std::begin(tables), std::end(tables));
  if (has_people(manifest)) made.push_back(&people_table);
  return made;
}

void put_page(TaskRun& run, std::size_t product, const std::string& text) {
  run.put_text(product, text, [&](const fs::path& file) {
    if (read_file(file) != text) throw std::runtime_error(file.string() + " is incomplete");
  });
}

}  // namespace

Hash study_key(const Manifest& manifest, const std::vector<fs::path>& documents,
               const SharedDeterminants& shared, const TaskGraph& graph) {
  KeyBuilder key;
  key.add("libraries", shared.libraries).add("repertoire", shared.repertoire);
  key.add("code", study_code());
  key.add("manifest", shared.files.of(manifest.file));
  key.add("command", manifest.command);
  for (const fs::path& document : documents) key.add("document", shared.files.of(document));
  add_page(key, manifest);
  key.add("made of", key_of(graph));
  return key.key();
}

std::vector<TableForm> study_table_forms() {
  std::vector<TableForm> forms;
  for (const StudyTable* table : tables) forms.push_back(table->form);
  return forms;
}

Task tables_task(const Manifest& manifest, Motions& motions, const Hash& study) {
  Task task;
  task.id = "tables";
  task.kind = "tables";
  task.determinants.add("study", study);
  for (const Stimulus* motion : motion_sources(manifest))
    task.inputs.push_back("motion:" + motion->id);
  const std::vector<const StudyTable*> made = tables_of(manifest);
  for (const StudyTable* table : made) task.products.push_back({std::string(table->form.path), {}});
  task.cost_seconds = tables_cost_seconds;
  task.make = [&manifest, &motions, made](TaskRun& run) {
    for (std::size_t i = 0; i < made.size(); ++i)
      run.put_text(i, made[i]->csv(manifest, motions), read_csv);
  };
  return task;
}

Task report_task(const Manifest& manifest, Motions& motions, const Hash& study,
                 const TaskGraph& graph) {
  Task task;
  task.id = "report";
  task.kind = "report";
  task.determinants.add("study", study);
  for (const Task& other : graph.tasks) task.inputs.push_back(other.id);
  task.products = {{"report.html", {}}, {"methods.md", {}}, {"references.bib", {}}};
  const std::vector<ReportPart> parts = report_parts(manifest);
  for (const ReportPart& part : parts) task.products.push_back({part.path(), {}});
  task.cost_seconds = report_cost_seconds * static_cast<double>(1 + parts.size());
  task.make = [&manifest, &motions, parts](TaskRun& run) {
    const Methods methods = methods_of(manifest, motions);
    const DesignFindings design = filmed_design(manifest, motions, run.store.folder());
    const FilmWarnings films = film_warnings(manifest, run.store.folder());
    put_page(run, 0, report(manifest, motions, methods, design, films));
    put_page(run, 1, methods.markdown);
    put_page(run, 2, methods.bibtex);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (run.stop.stop_requested()) throw Interrupted{};
      put_page(run, 3 + i, report_part(parts, i, manifest, motions, films));
    }
  };
  return task;
}

}  // namespace mien::pipeline
