#include "pipeline/film/film_sizes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "pipeline/documents/csv.h"
#include "pipeline/film/film_shot.h"
#include "pipeline/film/film_table_forms.h"
#include "scenes/cameras/camera_rig.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr const char* table_path = "metrics/sizes.csv";

}  // namespace

std::string sizes_csv(const Manifest& manifest, Motions& motions, TaskRun& run) {
  std::map<std::string, double> framed;
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (run.stop.stop_requested()) throw Interrupted{};
    const scenes::Shot shot = shot_of(stimulus, motions, manifest.seed);
    framed[stimulus.id] = scenes::figure_pixels(shot.cameras);
    run.progress(static_cast<double>(framed.size()) / static_cast<double>(manifest.stimuli.size()));
  }
  std::map<std::string, double> common;
  for (const auto& group : alike(manifest.stimuli, manifest.equalize.size_among)) {
    double least = std::numeric_limits<double>::infinity();
    for (const Stimulus* stimulus : group) least = std::min(least, framed.at(stimulus->id));
    // Steps of 1/64 pixel: no machine's arithmetic shows.
    for (const Stimulus* stimulus : group) common[stimulus->id] = std::floor(64.0 * least) / 64.0;
  }
  CsvWriter table = table_of(sizes_form);
  for (const Stimulus& stimulus : manifest.stimuli) {
    table.row({stimulus.id, shortest(std::round(100.0 * framed.at(stimulus.id)) / 100.0),
               shortest(common.at(stimulus.id))});
  }
  return table.text();
}

double figure_px_of(const fs::path& folder, const std::string& stimulus) {
  return number_of(folder / table_path, "figure_px", stimulus);
}

}  // namespace mien::pipeline
