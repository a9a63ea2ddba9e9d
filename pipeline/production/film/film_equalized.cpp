#include "pipeline/production/film/film_equalized.h"

#include <functional>
#include <utility>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/production/clips/durations.h"
#include "pipeline/production/film/film_exposure.h"
#include "pipeline/production/film/film_framing.h"
#include "pipeline/production/film/film_table_forms.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr double framing_cost_seconds = 0.2;  // a stimulus
constexpr double exposure_cost_seconds = 0.5;

/// A task that makes one table from all stimuli.
Task table_task(const std::string& name, const Manifest& manifest, const SharedDeterminants& shared,
                std::optional<Among> among, double cost_seconds,
                std::function<std::string(TaskRun&)> text_of) {
  Task task;
  task.id = task.kind = name;
  task.determinants.add("libraries", shared.libraries).add("code", film_code());
  task.determinants.add("seed", static_cast<std::int64_t>(manifest.seed))
      .add("duration", std::int64_t{manifest.equalize.duration})
      .add("among", static_cast<std::int64_t>(*among));
  for (const Stimulus& stimulus : manifest.stimuli) {
    task.inputs.push_back("motion:" + stimulus.id);
    task.determinants.add("stimulus", stimulus.id);
    add_film(task.determinants, stimulus, shared.files);
  }
  task.products.push_back({"metrics/" + name + ".csv", {}});
  task.cost_seconds = cost_seconds * static_cast<double>(manifest.stimuli.size());
  task.make = [text_of = std::move(text_of)](TaskRun& run) {
    const std::string text = text_of(run);
    run.store.put(
        run.task.products[0].path, run.keys[0],
        [&](const fs::path& file) { write_file(file, text); },
        [](const fs::path& file) { read_csv(file); });
  };
  return task;
}

}  // namespace

std::vector<Task> equalizing_tasks(const Manifest& manifest, const SharedDeterminants& shared,
                                   const FilmSettings& settings, FinishedMotions& motions) {
  std::vector<Task> tasks;
  const Equalize& equalize = manifest.equalize;
  if (equalize.size) {
    tasks.push_back(table_task(
        "sizes", manifest, shared, equalize.size, framing_cost_seconds,
        [&manifest, &motions](TaskRun& run) { return sizes_csv(manifest, motions, run); }));
  }
  if (equalize.place) {
    tasks.push_back(table_task(
        "places", manifest, shared, equalize.place, framing_cost_seconds,
        [&manifest, &motions](TaskRun& run) { return places_csv(manifest, motions, run); }));
    if (equalize.size) tasks.back().inputs.emplace_back("sizes");
  }
  if (equalize.luminance) {
    tasks.push_back(table_task("exposure", manifest, shared, equalize.luminance,
                               exposure_cost_seconds,
                               [&manifest, &motions, settings](TaskRun& run) {
                                 return exposure_csv(manifest, settings, motions, run);
                               }));
    if (equalize.size) tasks.back().inputs.emplace_back("sizes");
    if (equalize.place) tasks.back().inputs.emplace_back("places");
  }
  return tasks;
}

std::vector<std::string> equalizing_task_ids(const Equalize& equalize) {
  std::vector<std::string> ids;
  if (equalize.duration) ids.emplace_back(durations_task_id);
  if (equalize.luminance) ids.emplace_back("exposure");
  if (equalize.size) ids.emplace_back("sizes");
  if (equalize.place) ids.emplace_back("places");
  return ids;
}

std::vector<std::string> equalizing_tables(const Equalize& equalize) {
  std::vector<std::string> tables;
  const auto add = [&](const TableForm& form) { tables.emplace_back(form.path); };
  if (equalize.duration) add(durations_form);
  if (equalize.luminance) add(exposure_form);
  if (equalize.size) add(sizes_form);
  if (equalize.place) add(places_form);
  return tables;
}

Equalized equalized_film(const Equalize& equalize, const fs::path& folder,
                         const std::string& stimulus, FinishedMotions& motions) {
  if (equalize.duration) know_durations(folder, motions);
  Equalized alike;
  if (equalize.luminance) alike.exposure_stops = exposure_stops_of(folder, stimulus);
  alike.framing = equalized_framing(equalize, folder, stimulus);
  return alike;
}

}  // namespace mien::pipeline
