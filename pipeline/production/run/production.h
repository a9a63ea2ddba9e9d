#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/film/film_task.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/tasks/stopwatch.h"
#include "pipeline/tasks/task_graph.h"
#include "render/tracer/static_background_cache.h"

namespace mien::pipeline {

/// Command-line options that override a manifest.
struct ProductionOptions {
  std::optional<Quality> quality;  ///< overrides the quality of all films
  /// Ids of the stimuli, overlays and sheets to make; overlays and sheets whose stimuli are all
  /// named are made as well. Empty: everything.
  std::vector<std::string> only;
  int jobs = 1;
  Stopwatch* drawing = nullptr;  ///< if not null, runs while frames are drawn (FilmSettings)
};

/// The tasks of a run of the manifest:
///
///   task       inputs → result                   files
///   motion     examples, weights → motion        .mien/motions/<id>.json (a digest)
///   clip       motion → file                     clips/<id>.bvh, …
///   dots       motion → points                   clips/<id>.dots.csv
///   film       motions → shot → frames, video    frames/<id>/, videos/<id>.mp4,
///                                                sheets/contact/<id>.png,
///                                                metrics/films/<id>.json
///   sheet      motions → distances → page        sheets/<id>.pdf, .png
///              motions → shots → stills → page
///   durations  motions → durations               metrics/durations.csv: for equalized duration
///   sizes      motions → shots → sizes           metrics/sizes.csv: for equalized size
///   places     motions → shots → positions       metrics/places.csv: for equalized place
///   exposure   motions → shots → exposures       metrics/exposure.csv: for equalized luminance
///   tables     motions → measures                metrics/*.csv
///   films      films → measures                  metrics/luminance.csv, videos.csv, views.csv
///   design     motions, clips, films → factors   metrics/stimuli.csv, warnings.csv, codebook.json
///   report     all tasks → page, methods         report.html, methods.md, references.bib
///
/// With `only`, the tasks `tables`, `films`, `design` and `report` and the provenance are omitted.
class Production {
 public:
  /// Throws Error if `only` contains an id that is not in the manifest.
  Production(Manifest manifest, ProductionOptions options);
  Production(const Production&) = delete;
  Production& operator=(const Production&) = delete;

  const Manifest& manifest() const { return manifest_; }
  const TaskGraph& graph() const { return graph_; }
  Motions& motions() { return motions_; }
  bool is_whole() const { return options_.only.empty(); }

  /// Returns, for a whole production, the hashes of its input files at the time of planning
  /// (hashes_of_inputs); empty otherwise.
  const std::map<std::string, Hash>& inputs() const { return inputs_; }

 private:
  void add_motions(const SharedDeterminants& shared);
  void add_stimuli(const SharedDeterminants& shared);
  void add_overlays(const SharedDeterminants& shared);
  void add_sheets(const SharedDeterminants& shared);
  void add_study(const SharedDeterminants& shared);
  void add_film(const FilmSubject& subject, const SharedDeterminants& shared);
  void add(Task task, const Equalize& equalize);
  int threads() const;
  FilmSettings film_settings(const Output& output);
  bool is_wanted(const std::string& id) const;
  bool is_wanted_motion(const std::string& name) const;
  bool is_wanted(const Sheet& sheet) const;
  bool is_wanted(const Overlay& overlay) const;

  Manifest manifest_;
  ProductionOptions options_;
  Motions motions_;
  render::StaticBackgroundCache sets_;  ///< shared by all films
  TaskGraph graph_;
  std::set<std::string> wanted_;  ///< the ids in options_.only
  std::map<std::string, Hash> inputs_;
};

}  // namespace mien::pipeline
