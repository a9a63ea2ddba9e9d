#include "pipeline/film/film_sizes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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
  CsvWriter table = table_of(sizes_form);
  for (std::size_t i = 0; i < framed.size(); ++i) {
    table.row(
        {manifest.stimuli[i].id, shortest(std::round(100.0 * framed[i]) / 100.0), shortest(least)});
  }
  return table.text();
}

double figure_px_of(const fs::path& folder, const std::string& stimulus) {
  return number_of(folder / table_path, "figure_px", stimulus);
}

}  // namespace mien::pipeline
