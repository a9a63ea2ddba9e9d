#include "pipeline/film_sizes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "pipeline/code_identity.h"
#include "pipeline/csv.h"
#include "pipeline/files.h"
#include "pipeline/film_exposure.h"
#include "pipeline/film_shot.h"
#include "scenes/camera_rig.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr const char* table_path = "metrics/sizes.csv";
constexpr double cost_seconds = 0.2;

std::string sizes_csv(const Manifest& manifest, Motions& motions, TaskRun& run) {
  std::vector<double> framed;
  double least = std::numeric_limits<double>::infinity();
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (run.stop.stop_requested()) throw Interrupted{};
    const scenes::Shot shot = shot_of(stimulus, motions, manifest.seed);
    framed.push_back(scenes::figure_pixels(shot.cameras));
    least = std::min(least, framed.back());
    run.progress(static_cast<double>(framed.size()) / static_cast<double>(manifest.stimuli.size()));
  }
  // Steps of 1/64 pixel: no machine's arithmetic shows.
  least = std::floor(64.0 * least) / 64.0;
  CsvWriter table({"stimulus", "framed_px", "figure_px"});
  for (std::size_t i = 0; i < framed.size(); ++i) {
    table.row(
        {manifest.stimuli[i].id, shortest(std::round(100.0 * framed[i]) / 100.0), shortest(least)});
  }
  return table.text();
}

}  // namespace

Equalized equalized_film(const Equalize& equalize, const fs::path& folder,
                         const std::string& stimulus) {
  Equalized alike;
  if (equalize.luminance) alike.exposure_stops = exposure_stops_of(folder, stimulus);
  if (equalize.size) alike.figure_px = figure_px_of(folder, stimulus);
  return alike;
}

std::vector<std::string> equalizing_tasks(const Equalize& equalize) {
  std::vector<std::string> tasks;
  if (equalize.luminance) tasks.emplace_back("exposure");
  if (equalize.size) tasks.emplace_back("sizes");
  return tasks;
}

Task sizes_task(const Manifest& manifest, const SharedDeterminants& shared, Motions& motions) {
  Task task;
  task.id = "sizes";
  task.kind = "sizes";
  task.determinants.add("libraries", shared.libraries).add("code", film_code());
  task.determinants.add("seed", static_cast<std::int64_t>(manifest.seed))
      .add("duration", std::int64_t{manifest.equalize.duration});
  for (const Stimulus& stimulus : manifest.stimuli) {
    task.inputs.push_back("motion:" + stimulus.id);
    task.determinants.add("stimulus", stimulus.id);
    add_film(task.determinants, stimulus);
  }
  task.products.push_back({table_path, {}});
  task.cost_seconds = cost_seconds * static_cast<double>(manifest.stimuli.size());
  task.make = [&manifest, &motions](TaskRun& run) {
    const std::string text = sizes_csv(manifest, motions, run);
    run.store.put(
        run.task.products[0].path, run.keys[0],
        [&](const fs::path& file) { write_file(file, text); },
        [](const fs::path& file) { read_csv(file); });
  };
  return task;
}

double figure_px_of(const fs::path& folder, const std::string& stimulus) {
  return number_of(folder / table_path, "figure_px", stimulus);
}

}  // namespace mien::pipeline
