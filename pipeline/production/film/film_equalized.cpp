#include "pipeline/production/film/film_equalized.h"

#include <functional>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/people.h"
#include "pipeline/production/film/film_exposure.h"
#include "pipeline/production/film/film_framing.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EqualizedFilms, exposure_stops, figure_px, figure_place)

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double framing_cost_seconds = 0.2;  // a stimulus
constexpr double exposure_cost_seconds = 0.5;

std::string record_path(const std::string& task) { return ".mien/equalized/" + task + ".json"; }

EqualizedFilms recorded(const fs::path& file) {
  return json::parse(read_file(file)).get<EqualizedFilms>();
}

/// Adds to what has been found, and returns the table of it.
using Find = std::function<std::string(TaskRun&, EqualizedFilms&)>;

/// A task that finds something from all stimuli and from what the task `before` has found, if there
/// is one.
Task finding_task(const std::string& name, const std::string& before, const Manifest& manifest,
                  const SharedDeterminants& shared, EqualizeGroup among, double cost_seconds,
                  Find find) {
  Task task;
  task.id = task.kind = name;
  task.determinants.add("libraries", shared.libraries).add("code", film_code());
  task.determinants.add("seed", static_cast<std::int64_t>(manifest.seed))
      .add("duration", std::int64_t{manifest.equalize.duration})
      .add("among", static_cast<std::int64_t>(among));
  for (const Stimulus& stimulus : manifest.stimuli) {
    for (const Stimulus* motion : motions_in(stimulus))
      task.inputs.push_back("motion:" + motion->id);
    task.determinants.add("stimulus", stimulus.id);
    add_film(task.determinants, stimulus, shared.files);
  }
  if (!before.empty()) task.inputs.push_back(before);
  task.products = {{"metrics/" + name + ".csv", {}}, {record_path(name), {}}};
  task.cost_seconds = cost_seconds * static_cast<double>(manifest.stimuli.size());
  task.make = [before, find = std::move(find)](TaskRun& run) {
    EqualizedFilms films;
    if (!before.empty()) films = recorded(run.store.folder() / record_path(before));
    run.put_text(0, find(run, films), read_csv);
    run.put_text(1, json(films).dump(), recorded);
  };
  return task;
}

}  // namespace

Equalized EqualizedFilms::of(const std::string& stimulus) const {
  const auto in = [&]<class Number>(const std::map<std::string, Number>& found) {
    const auto one = found.find(stimulus);
    return one == found.end() ? std::optional<Number>() : one->second;
  };
  return {static_cast<float>(in(exposure_stops).value_or(0.0)), {in(figure_px), in(figure_place)}};
}

std::vector<Task> equalizing_tasks(const Manifest& manifest, const SharedDeterminants& shared,
                                   const FilmSettings& settings, FinishedMotions& motions) {
  std::vector<Task> tasks;
  const auto add = [&](const char* name, std::optional<EqualizeGroup> among, double cost,
                       Find find) {
    if (!among) return;
    const std::string before = tasks.empty() ? std::string() : tasks.back().id;
    tasks.push_back(finding_task(name, before, manifest, shared, *among, cost, std::move(find)));
  };
  add("sizes", manifest.equalize.size, framing_cost_seconds,
      [&](TaskRun& run, EqualizedFilms& films) {
        return sizes_csv(manifest, motions, run, films);
      });
  add("places", manifest.equalize.place, framing_cost_seconds,
      [&](TaskRun& run, EqualizedFilms& films) {
        return places_csv(manifest, motions, run, films);
      });
  add("exposure", manifest.equalize.luminance, exposure_cost_seconds,
      [&, settings](TaskRun& run, EqualizedFilms& films) {
        return exposure_csv(manifest, settings, motions, run, films);
      });
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

EqualizedFilms equalized_films(const Equalize& equalize, const fs::path& folder,
                               FinishedMotions& motions) {
  if (equalize.duration) know_durations(folder, motions);
  const std::string last = equalize.luminance ? "exposure"
                           : equalize.place   ? "places"
                           : equalize.size    ? "sizes"
                                              : "";
  return last.empty() ? EqualizedFilms{} : recorded(folder / record_path(last));
}

}  // namespace mien::pipeline
