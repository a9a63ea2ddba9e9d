#include "pipeline/production/sheets/stills_task.h"

#include <string>

#include "pipeline/manifest/people.h"
#include "pipeline/production/film/disk_light_cache.h"
#include "pipeline/production/film/film_equalized.h"
#include "pipeline/production/film/film_shot.h"
#include "pipeline/production/sheets/sheet_content.h"
#include "pipeline/production/sheets/sheet_task.h"
#include "pipeline/production/sheets/stills.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

constexpr double still_cost_seconds = 1.0;

render::Image8 still_of(const Stimulus& stimulus, FilmSettings settings, Motions& motions,
                        const Equalized& alike, const std::stop_token& stop) {
  settings.output = stimulus.output;
  scenes::Shot shot = shot_of(stimulus, motions, settings.seed, alike.framing);
  shot.tone.exposure_stops += alike.exposure_stops;
  render::Image8 still;
  draw_frames(
      shot, {shot.frame_count() / 2}, settings, nullptr,
      [&](int, const render::Image8& picture) { still = picture; }, stop, [](double) {});
  return still;
}

StillsContent stills_content(const Sheet& sheet, const Manifest& manifest,
                             const FilmSettings& settings, Motions& motions, TaskRun& run) {
  StillsContent content{manifest.study, sheet.id, {}, sheet.columns, provenance_of(manifest)};
  const EqualizedFilms alike = equalized_films(manifest.equalize, run.store.folder(), motions);
  for (const std::string& id : sheet.stills) {
    content.stills.push_back(
        {id, still_of(*motions.stimulus(id), settings, motions, alike.of(id), run.stop)});
    run.progress(static_cast<double>(content.stills.size()) /
                 static_cast<double>(sheet.stills.size()));
  }
  return content;
}

}  // namespace

Task stills_task(const Sheet& sheet, const Manifest& manifest, const FilmSettings& settings,
                 const SharedDeterminants& shared, Motions& motions) {
  Task task;
  task.id = "sheet:" + sheet.id;
  task.kind = "sheet";
  task.determinants.add("libraries", shared.libraries);
  task.determinants.add("code", sheet_code());
  add_printed(task.determinants, manifest);
  task.determinants.add("columns", std::int64_t{sheet.columns})
      .add("duration", std::int64_t{manifest.equalize.duration});
  for (const std::string& id : sheet.stills) {
    for (const Stimulus* motion : motions_in(*motions.stimulus(id)))
      task.inputs.push_back("motion:" + motion->id);
    task.determinants.add("still", id);
    add_film(task.determinants, *motions.stimulus(id), shared.files);
  }
  for (const std::string& other : equalizing_task_ids(manifest.equalize))
    task.inputs.push_back(other);
  task.products = sheet_products(sheet);
  task.cost_seconds = still_cost_seconds * static_cast<double>(sheet.stills.size());
  task.make = [&sheet, &manifest, &motions, settings](TaskRun& run) {
    FilmSettings kept = settings;
    kept.light_cache = disk_light_cache(run.store, run.stop);
    const StillsContent content = stills_content(sheet, manifest, kept, motions, run);
    put_sheet(run, stills_as_pdf(content), stills_as_png(content));
  };
  return task;
}

}  // namespace mien::pipeline
