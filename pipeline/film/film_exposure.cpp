#include "pipeline/film/film_exposure.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "pipeline/documents/csv.h"
#include "pipeline/film/film_shot.h"
#include "pipeline/film/film_sizes.h"
#include "pipeline/film/film_table_forms.h"
#include "render/image/contact_sheet.h"
#include "render/image/luminance.h"
#include "render/tracer/tracer.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr const char* table_path = "metrics/exposure.csv";
constexpr int sampled_frames = 8;
constexpr int most_width = 320;
constexpr float most_stops = 8.0f;
constexpr int halvings = 24;  // to a millionth of a stop
constexpr double luminance_tolerance = 0.01;

double mean_of(const std::vector<render::Film>& films, render::Tone tone, float stops) {
  tone.exposure_stops += stops;
  double sum = 0.0;
  for (const render::Film& film : films) sum += render::mean_luminance(film, tone);
  return sum / static_cast<double>(films.size());
}

/// Small frames, spread over the film, and how they are shown.
struct Samples {
  std::vector<render::Film> films;
  render::Tone tone;
};

Samples samples_of(const Stimulus& stimulus, const FilmSettings& settings, Motions& motions,
                   std::optional<double> figure_px, const std::stop_token& stop) {
  Stimulus small = stimulus;
  small.output.scale *=
      std::min(1.0, static_cast<double>(most_width) / stimulus.output.shown_size()[0]);
  if (figure_px) *figure_px *= small.output.scale / stimulus.output.scale;
  const scenes::Shot shot = shot_of(small, motions, settings.seed, figure_px);
  render::Tracer tracer({.threads = settings.threads, .instruction_set = ""});
  render::Quality quality = render::draft_quality();
  quality.seed = settings.seed;
  Samples samples{.tone = shot.tone};
  for (const int frame : render::evenly_spread(shot.frame_count(), sampled_frames)) {
    if (stop.stop_requested()) throw Interrupted{};
    samples.films.push_back(tracer.trace(scene_at(shot, frame), camera_at(shot, frame), quality));
  }
  return samples;
}

}  // namespace

float stops_for(const std::vector<render::Film>& films, const render::Tone& tone, double wanted) {
  float low = -most_stops;
  float high = most_stops;
  for (int i = 0; i < halvings; ++i) {
    const float middle = 0.5f * (low + high);
    (mean_of(films, tone, middle) < wanted ? low : high) = middle;
  }
  return 0.5f * (low + high);
}

std::string exposure_csv(const Manifest& manifest, const FilmSettings& settings, Motions& motions,
                         TaskRun& run) {
  std::vector<Samples> samples;
  std::vector<double> means;
  double logarithms = 0.0;
  for (const Stimulus& stimulus : manifest.stimuli) {
    std::optional<double> figure_px;
    if (manifest.equalize.size) figure_px = figure_px_of(run.store.folder(), stimulus.id);
    samples.push_back(samples_of(stimulus, settings, motions, figure_px, run.stop));
    means.push_back(mean_of(samples.back().films, samples.back().tone, 0.0f));
    logarithms += std::log(std::max(means.back(), 1e-6));
    run.progress(static_cast<double>(means.size()) / static_cast<double>(manifest.stimuli.size()));
  }
  const double wanted = std::exp(logarithms / static_cast<double>(means.size()));
  CsvWriter table = table_of(exposure_form);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    // Steps of 1/4096 stop: no machine's logarithm shows.
    const double stops = std::round(
        4096.0 * static_cast<double>(stops_for(samples[i].films, samples[i].tone, wanted)));
    const double reached =
        mean_of(samples[i].films, samples[i].tone, static_cast<float>(stops / 4096.0));
    if (std::abs(reached - wanted) > luminance_tolerance * wanted) {
      throw Error("equalize: \"" + manifest.stimuli[i].id + "\" has a mean luminance of " +
                      shortest(std::round(1e3 * reached) / 1e3) +
                      " at most, where the others need " + shortest(std::round(1e3 * wanted) / 1e3),
                  "leave luminance out of equalize, or give it another background");
    }
    table.row({manifest.stimuli[i].id, shortest(std::round(1e6 * means[i]) / 1e6),
               shortest(std::round(1e6 * wanted) / 1e6), shortest(stops / 4096.0)});
  }
  return table.text();
}

float exposure_stops_of(const fs::path& folder, const std::string& stimulus) {
  return static_cast<float>(number_of(folder / table_path, "exposure_stops", stimulus));
}

}  // namespace mien::pipeline
