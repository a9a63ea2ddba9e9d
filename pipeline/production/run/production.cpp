#include "pipeline/production/run/production.h"

#include <algorithm>
#include <stdexcept>
#include <thread>
#include <utility>

#include <nlohmann/json.hpp>

#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "motion/text/shell_word.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/determinants.h"
#include "pipeline/manifest/people.h"
#include "pipeline/production/film/film_dots.h"
#include "pipeline/production/film/film_equalized.h"
#include "pipeline/production/film/film_tables.h"
#include "pipeline/production/report/study_tasks.h"
#include "pipeline/production/run/codebook.h"
#include "pipeline/production/run/stimuli_table.h"
#include "pipeline/production/run/study_inputs.h"
#include "pipeline/production/sheets/sheet_task.h"
#include "pipeline/production/sheets/stills_task.h"
#include "pipeline/production/synthesis/durations_task.h"
#include "pipeline/production/synthesis/motion_task.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr double cost_seconds = 0.02;

void check_json(const fs::path& file) {
  if (!nlohmann::json::accept(read_file(file)))
    throw std::runtime_error(file.string() + " is incomplete");
}

/// The task "design": metrics/stimuli.csv, metrics/warnings.csv (stimuli_table.h),
/// metrics/codebook.json (codebook.h) metrics/confounds.csv (confounds.h) and
/// metrics/close_levels.csv (close_levels.h). It reads the
/// products of the motions, clips and films of `graph`. `study` is the study's key; `manifest` and
/// `motions` outlive the task.
Task design_task(const Manifest& manifest, Motions& motions, const Hash& study,
                 const TaskGraph& graph) {
  Task task;
  task.id = task.kind = "design";
  task.determinants.add("study", study);
  for (const Task& other : graph.tasks) {
    if (other.kind == "motion" || other.kind == "clip" || other.kind == "film")
      task.inputs.push_back(other.id);
  }
  task.products = {{std::string(stimuli_form.path), {}},
                   {std::string(warnings_form.path), {}},
                   {"metrics/codebook.json", {}},
                   {std::string(confounds_form.path), {}},
                   {std::string(close_levels_form.path), {}}};
  task.cost_seconds = cost_seconds;
  task.make = [&manifest, &motions](TaskRun& run) {
    const fs::path& folder = run.store.folder();
    run.put_text(0, stimuli_csv(manifest, motions, folder), read_csv);
    const DesignFindings design = filmed_design(manifest, motions, folder);
    run.put_text(1, warnings_csv(manifest, motions, folder, design), read_csv);
    run.put_text(2, codebook_json(manifest), check_json);
    run.put_text(3, confounds_csv(design.properties), read_csv);
    run.put_text(4, close_levels_csv(design.close), read_csv);
  };
  return task;
}

/// The task, with its errors located at a path of the manifest, unless they name a file. `places`
/// outlives the task.
Task located_at(Task task, const Places& places, const std::string& path) {
  const auto locating = [&places, path](const auto& work) {
    try {
      work();
    } catch (const Error& error) {
      if (!error.place().file.empty()) throw;
      throw Error(place_of(places, path), path + ": " + error.what(), "");
    }
  };
  if (task.make)
    task.make = [locating, make = std::move(task.make)](TaskRun& run) {
      locating([&] { make(run); });
    };
  if (task.make_part)
    task.make_part = [locating, make = std::move(task.make_part)](TaskRun& run, const Part& part) {
      locating([&] { make(run, part); });
    };
  return task;
}

/// "mien run study.yaml --quality draft". One taken from a provenance.json stays as it is.
std::string command_of(const Manifest& manifest, const std::optional<Quality>& quality) {
  if (!quality && !manifest.command.empty()) return manifest.command;
  std::string command = "mien run " + motion::shell_path(manifest.file.filename().string());
  if (quality) command += " --quality " + std::string(name_of(*quality));
  return command;
}

/// Replaces the quality. Samples per pixel can be stated for reference quality only.
void replace_quality(Output& output, Quality quality) {
  output.quality = quality;
  if (quality != Quality::reference) output.samples = Output().samples;
}

Manifest with_quality(Manifest manifest, const std::optional<Quality>& quality) {
  manifest.command = command_of(manifest, quality);
  if (!quality) return manifest;
  replace_quality(manifest.output, *quality);
  for (Stimulus& stimulus : manifest.stimuli) replace_quality(stimulus.output, *quality);
  for (Overlay& overlay : manifest.overlays) replace_quality(overlay.film.output, *quality);
  return manifest;
}

void refuse_unknown_ids(const Manifest& manifest, const std::vector<std::string>& only) {
  if (only.empty()) return;
  std::vector<std::string> ids;
  std::set<std::string> known;
  const auto add = [&](const std::string& id) {  // a sheet may have a stimulus' name
    if (known.insert(id).second) ids.push_back(id);
  };
  for (const Stimulus* film : films_of(manifest)) add(film->id);
  for (const Sheet& sheet : manifest.sheets) add(sheet.id);
  for (const std::string& id : only) {
    if (known.contains(id)) continue;
    throw Error("--only: there is no stimulus, overlay or sheet " + motion::in_quotes(id),
                motion::did_you_mean(id, ids));
  }
}

}  // namespace

Production::Production(Manifest manifest, ProductionOptions options)
    : manifest_(with_quality(std::move(manifest), options.quality)),
      options_(std::move(options)),
      motions_(manifest_),
      wanted_(options_.only.begin(), options_.only.end()) {
  refuse_unknown_ids(manifest_, options_.only);
  FileKeys files;
  const SharedDeterminants shared = shared_determinants(manifest_, files);
  add_motions(shared);
  add_stimuli(shared);
  add_overlays(shared);
  add_sheets(shared);
  if (!is_whole()) return;
  add_study(shared);
  inputs_ = hashes_of_inputs(manifest_);
}

/// The motions, and the tasks that equalize films across them.
void Production::add_motions(const SharedDeterminants& shared) {
  for (const Stimulus* motion : motion_sources(manifest_))
    graph_.add(located_at(motion_task(*motion, shared, motions_), manifest_.places, motion->path));
  if (manifest_.equalize.duration) graph_.add(durations_task(manifest_, shared, motions_));
  const FilmSettings settings{.seed = manifest_.seed, .threads = threads(), .sets = &sets_};
  for (Task& task : equalizing_tasks(manifest_, shared, settings, motions_)) {
    graph_.add(std::move(task));
  }
}

void Production::add_stimuli(const SharedDeterminants& shared) {
  const Equalize& equalize = manifest_.equalize;
  for (const Stimulus& stimulus : manifest_.stimuli) {
    if (!is_wanted(stimulus.id)) continue;
    for (const Stimulus* motion : motions_in(stimulus)) {
      if (!motion->output.clips.empty())
        add(located_at(clip_task(*motion, equalize, shared, motions_), manifest_.places,
                       motion->path),
            equalize);
    }
    if (has_dots(stimulus)) {
      add(located_at(dots_task(stimulus, manifest_.seed, equalize, shared, motions_),
                     manifest_.places, stimulus.path),
          equalize);
    }
    add_film(subject_of(stimulus, manifest_, motions_), shared);
  }
}

void Production::add_overlays(const SharedDeterminants& shared) {
  for (const Overlay& overlay : manifest_.overlays) {
    if (is_wanted(overlay)) add_film(subject_of(overlay, manifest_, motions_, shared), shared);
  }
}

void Production::add_sheets(const SharedDeterminants& shared) {
  for (const Sheet& sheet : manifest_.sheets) {
    if (!is_wanted(sheet)) continue;
    if (sheet.stills.empty()) {
      graph_.add(
          located_at(sheet_task(sheet, manifest_, shared, motions_), manifest_.places, sheet.path));
    } else {
      add(located_at(stills_task(sheet, manifest_, film_settings({}), shared, motions_),
                     manifest_.places, sheet.path),
          manifest_.equalize);
    }
  }
}

/// What covers the whole study.
void Production::add_study(const SharedDeterminants& shared) {
  std::vector<fs::path> documents;
  for (const InputCopy& copy : input_copies(manifest_)) documents.push_back(copy.source);
  const Hash study = study_key(manifest_, documents, shared, graph_);
  graph_.add(tables_task(manifest_, motions_, study));
  graph_.add(films_task(manifest_, shared));
  graph_.add(design_task(manifest_, motions_, study, graph_));
  graph_.add(report_task(manifest_, motions_, study, graph_));
}

void Production::add_film(const FilmSubject& subject, const SharedDeterminants& shared) {
  const FilmSettings settings = film_settings(subject.film.output);
  add(located_at(film_task(subject, settings, shared, motions_), manifest_.places,
                 subject.film.path),
      subject.equalize);
}

/// A task that shows motions. It waits for the equalizing tasks: if these fail, no clip of the
/// study is made.
void Production::add(Task task, const Equalize& equalize) {
  task.after = equalizing_task_ids(equalize);
  graph_.add(std::move(task));
}

int Production::threads() const {
  const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return std::min(options_.jobs, processors);
}

FilmSettings Production::film_settings(const Output& output) {
  return {.output = output,
          .seed = manifest_.seed,
          .threads = threads(),
          .drawing = options_.drawing,
          .sets = &sets_};
}

bool Production::is_wanted(const std::string& id) const {
  return wanted_.empty() || wanted_.contains(id);
}

bool Production::is_wanted_motion(const std::string& name) const {
  const auto shows = [&](const Stimulus& stimulus) {
    const auto motions = motions_in(stimulus);
    return is_wanted(stimulus.id) &&
           std::ranges::find(motions, name, &Stimulus::id) != motions.end();
  };
  return motions_.stimulus(name) == nullptr || is_wanted(name) ||
         std::ranges::any_of(manifest_.stimuli, shows);
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
