#include "pipeline/production/production.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "motion/text/nearest_word.h"
#include "pipeline/film/film_dots.h"
#include "pipeline/film/film_equalized.h"
#include "pipeline/film/film_tables.h"
#include "pipeline/film/film_task.h"
#include "pipeline/manifest/determinants.h"
#include "pipeline/report/study_tasks.h"
#include "pipeline/sheets/sheet_task.h"
#include "pipeline/sheets/stills_task.h"
#include "pipeline/synthesis/motion_task.h"

namespace mien::pipeline {

namespace {

Manifest with_quality(Manifest manifest, const std::optional<Quality>& quality) {
  if (!quality) return manifest;
  manifest.output.quality = *quality;
  for (Stimulus& stimulus : manifest.stimuli) stimulus.output.quality = *quality;
  for (Overlay& overlay : manifest.overlays) overlay.film.output.quality = *quality;
  return manifest;
}

void refuse_unknown_ids(const Manifest& manifest, const std::vector<std::string>& only) {
  std::vector<std::string> ids;
  const auto add = [&](const std::string& id) {  // a sheet may have a stimulus' name
    if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
  };
  for (const Stimulus* film : films_of(manifest)) add(film->id);
  for (const Sheet& sheet : manifest.sheets) add(sheet.id);
  for (const std::string& id : only) {
    if (std::find(ids.begin(), ids.end(), id) != ids.end()) continue;
    throw Error("--only: there is no stimulus, overlay or sheet \"" + id + "\"",
                motion::did_you_mean(id, ids));
  }
}

}  // namespace

Production::Production(Manifest manifest, ProductionOptions options)
    : manifest_(with_quality(std::move(manifest), options.quality)),
      options_(std::move(options)),
      motions_(manifest_) {
  refuse_unknown_ids(manifest_, options_.only);
  const SharedDeterminants shared = shared_determinants(manifest_);
  const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int threads = std::min(options_.jobs, processors);
  for (const Stimulus& stimulus : manifest_.stimuli) {
    graph_.add(motion_task(stimulus, shared, motions_));
  }
  for (Task& task : equalizing_tasks(manifest_, shared,
                                     {.seed = manifest_.seed, .threads = threads}, motions_)) {
    graph_.add(std::move(task));
  }
  for (const Stimulus& stimulus : manifest_.stimuli) {
    if (!is_wanted(stimulus.id)) continue;
    if (stimulus.output.clips.bvh || stimulus.output.clips.glb) {
      Task clip = clip_task(stimulus, shared, motions_);
      if (manifest_.equalize.duration) depend_on_motions(clip);
      graph_.add(std::move(clip));
    }
    if (has_dots(stimulus)) {
      Task dots = dots_task(stimulus, manifest_.seed, manifest_.equalize, shared, motions_);
      if (manifest_.equalize.duration) depend_on_motions(dots);
      graph_.add(std::move(dots));
    }
    add_film(subject_of(stimulus, manifest_, motions_), threads, shared);
  }
  for (const Overlay& overlay : manifest_.overlays) {
    if (!is_wanted(overlay)) continue;
    add_film(subject_of(overlay, manifest_, motions_, shared), threads, shared);
  }
  for (const Sheet& sheet : manifest_.sheets) {
    if (!is_wanted(sheet)) continue;
    if (sheet.stills.empty()) {
      graph_.add(sheet_task(sheet, manifest_, shared, motions_));
      continue;
    }
    const FilmSettings settings{
        .seed = manifest_.seed, .threads = threads, .drawing = options_.drawing};
    Task stills = stills_task(sheet, manifest_, settings, shared, motions_);
    if (manifest_.equalize.duration) depend_on_motions(stills);
    graph_.add(std::move(stills));
  }
  if (!is_whole()) return;
  graph_.add(tables_task(manifest_, motions_, shared));
  graph_.add(films_task(manifest_, shared));
  graph_.add(report_task(manifest_, motions_, shared, graph_));
}

void Production::add_film(const FilmSubject& subject, int threads,
                          const SharedDeterminants& shared) {
  const FilmSettings settings{.output = subject.film.output,
                              .seed = manifest_.seed,
                              .threads = threads,
                              .drawing = options_.drawing};
  Task task = film_task(subject, settings, shared, manifest_, motions_);
  if (subject.equalize.duration) depend_on_motions(task);
  graph_.add(std::move(task));
}

/// Where all stimuli last as long as the shortest, each depends on all motions.
void Production::depend_on_motions(Task& task) const {
  for (const Stimulus& stimulus : manifest_.stimuli) {
    const std::string motion = "motion:" + stimulus.id;
    if (std::find(task.inputs.begin(), task.inputs.end(), motion) == task.inputs.end()) {
      task.inputs.push_back(motion);
    }
  }
}

bool Production::is_wanted(const std::string& id) const {
  const std::vector<std::string>& only = options_.only;
  return only.empty() || std::find(only.begin(), only.end(), id) != only.end();
}

bool Production::is_wanted_motion(const std::string& name) const {
  return find_stimulus(manifest_, name) == nullptr || is_wanted(name);
}

/// A sheet or overlay is wanted when it is named, or when the stimuli that it shows all are.
bool Production::is_wanted(const Sheet& sheet) const {
  const std::vector<std::string> motions = motions_on(sheet);
  return is_wanted(sheet.id) || std::all_of(motions.begin(), motions.end(), [&](const auto& name) {
           return is_wanted_motion(name);
         });
}

bool Production::is_wanted(const Overlay& overlay) const {
  const auto motions = motions_on(overlay);
  return is_wanted(overlay.film.id) ||
         std::all_of(motions.begin(), motions.end(),
                     [&](const auto& one) { return is_wanted_motion(one.second); });
}

}  // namespace mien::pipeline
