#include "pipeline/production/film/film_exposure.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "pipeline/base/documents/fault_list.h"
#include "pipeline/production/film/film_shot.h"
#include "render/image/contact_sheet.h"
#include "render/image/luminance.h"
#include "render/tracer/tracer.h"

namespace mien::pipeline {

namespace {

constexpr float most_stops = 8.0f;
constexpr int halvings = 24;  // to a millionth of a stop

/// What is drawn to find how light a film is, and how near to the others it must come.
struct Sampling {
  int frames = 8;
  int most_width = 320;
  double tolerance = 0.01;
};

/// Enough to find what is out of reach by far.
constexpr Sampling quick_sampling = {.frames = 3, .most_width = 96, .tolerance = 0.05};

/// The quality of the small frames: a mean over a picture needs few samples of each pixel.
render::Quality metering_quality() {
  render::Quality quality = render::draft_quality();
  quality.samples_per_pixel = 4;
  quality.floor_sky_noise = 0.008f;
  return quality;
}

double mean_of(const std::vector<render::Framebuffer>& films, render::Tone tone, float stops) {
  tone.exposure_stops += stops;
  double sum = 0.0;
  for (const render::Framebuffer& film : films) sum += render::mean_luminance(film, tone);
  return sum / static_cast<double>(films.size());
}

/// Small frames, spread over the film, and how they are shown.
struct Samples {
  std::vector<render::Framebuffer> films;
  render::Tone tone;
};

Samples samples_of(const Stimulus& stimulus, const Sampling& sampling, const FilmSettings& settings,
                   FinishedMotions& motions, Framing framing, const std::stop_token& stop) {
  Stimulus small = stimulus;
  const double scale =
      std::min(1.0, static_cast<double>(sampling.most_width) / stimulus.output.shown_size()[0]);
  small.output.scale *= scale;
  if (framing.figure_px) *framing.figure_px *= scale;
  if (framing.figure_place) {
    for (double& from_middle : *framing.figure_place) from_middle *= scale;
  }
  const scenes::Shot shot = shot_of(small, motions, settings.seed, framing);
  render::Tracer tracer(tracer_options(settings, shot, stop));
  render::Quality quality = metering_quality();
  quality.seed = settings.seed;
  Samples samples{.tone = shot.tone};
  for (const int frame : render::evenly_spread(shot.frame_count(), sampling.frames)) {
    if (stop.stop_requested()) throw Interrupted{};
    samples.films.push_back(tracer.trace(scene_at(shot, frame), camera_at(shot, frame), quality));
  }
  return samples;
}

/// How light a film is, how light all should be, and what brings it there.
struct Adjustment {
  double mean = 0.0;
  double wanted = 0.0;
  double stops = 0.0;
  double reached = 0.0;

  bool is_there(const Sampling& sampling) const {
    return std::abs(reached - wanted) <= sampling.tolerance * wanted;
  }
};

/// Samples by stimulus id.
using SamplesById = std::map<std::string, Samples>;
using AdjustmentsById = std::map<std::string, Adjustment>;

/// What the luminance of dots depends on.
struct DotsLook {
  std::string scene, background;
  Role role;
  scenes::Figure figure;

  friend bool operator==(const DotsLook&, const DotsLook&) = default;
};

/// Without what only moves dots; nothing where there are none.
std::optional<DotsLook> dots_look(const Stimulus& stimulus) {
  DotsLook look = {stimulus.look.scene, stimulus.look.background, film_role(stimulus),
                   stimulus.look.figure};
  scenes::PointLightOptions* dots = scenes::dots_in(look.figure);
  if (dots == nullptr) return std::nullopt;
  const scenes::PointLightOptions usual;
  dots->lifetime = usual.lifetime;
  dots->inverted = usual.inverted;
  dots->mirrored = usual.mirrored;
  dots->rotated_degrees = usual.rotated_degrees;
  dots->scrambled = usual.scrambled;
  dots->reversed = usual.reversed;
  dots->constant_speed = usual.constant_speed;
  dots->phase_scrambled = usual.phase_scrambled;
  dots->seed = usual.seed;
  return look;
}

/// Films with one exposure.
using Lit = std::vector<const Stimulus*>;

/// Each film separately, except point-light films: those of one look together.
std::vector<Lit> lit_together(const std::vector<const Stimulus*>& group) {
  std::vector<Lit> all;
  std::vector<std::pair<DotsLook, std::size_t>> looks;
  for (const Stimulus* stimulus : group) {
    const std::optional<DotsLook> look = dots_look(*stimulus);
    const auto known =
        std::ranges::find_if(looks, [&](const auto& one) { return look && one.first == *look; });
    if (known != looks.end()) {
      all[known->second].push_back(stimulus);
      continue;
    }
    if (look) looks.emplace_back(*look, all.size());
    all.push_back({stimulus});
  }
  return all;
}

double mean_of(const Lit& lit, const SamplesById& samples, float stops) {
  double sum = 0.0;
  for (const Stimulus* stimulus : lit) {
    const auto& [films, tone] = samples.at(stimulus->id);
    sum += mean_of(films, tone, stops);
  }
  return sum / static_cast<double>(lit.size());
}

/// The stops at which a mean that rises with them is as wanted; the nearest end where there are
/// none.
template <class Mean>
float stops_where(const Mean& mean, double wanted) {
  float low = -most_stops;
  float high = most_stops;
  for (int i = 0; i < halvings; ++i) {
    const float middle = 0.5f * (low + high);
    (mean(middle) < wanted ? low : high) = middle;
  }
  return 0.5f * (low + high);
}

/// The exposures of one group, which bring its films to the geometric mean of their means.
void adjust(const std::vector<const Stimulus*>& group, const SamplesById& samples,
            AdjustmentsById& adjustments) {
  const std::vector<Lit> all = lit_together(group);
  double logarithms = 0.0;
  for (const Lit& lit : all) {
    const double mean = mean_of(lit, samples, 0.0f);
    for (const Stimulus* stimulus : lit) {
      adjustments[stimulus->id].mean = mean_of({stimulus}, samples, 0.0f);
      logarithms += std::log(std::max(mean, 1e-6));
    }
  }
  const double wanted = std::exp(logarithms / static_cast<double>(group.size()));
  for (const Lit& lit : all) {
    const auto mean = [&](float stops) { return mean_of(lit, samples, stops); };
    // Steps of 1/4096 stop: no machine's logarithm shows.
    const double stops =
        std::round(4096.0 * static_cast<double>(stops_where(mean, wanted))) / 4096.0;
    for (const Stimulus* stimulus : lit) {
      Adjustment& found = adjustments[stimulus->id];
      found.stops = stops;
      found.wanted = wanted;
      found.reached = mean(static_cast<float>(stops));
    }
  }
}

AdjustmentsById adjustments_of(const Manifest& manifest, const SamplesById& samples) {
  AdjustmentsById adjustments;
  for (const auto& group : equalized_groups(manifest.stimuli, *manifest.equalize.luminance))
    adjust(group, samples, adjustments);
  return adjustments;
}

std::vector<Fault> faults_of(const Manifest& manifest, const AdjustmentsById& adjustments,
                             const Sampling& sampling) {
  FaultList list(manifest.places);
  for (const Stimulus& stimulus : manifest.stimuli) {
    const Adjustment& found = adjustments.at(stimulus.id);
    if (found.is_there(sampling)) continue;
    list.add("equalize",
             fmt::format("no exposure makes \"{}\" as bright as the others: the nearest mean "
                         "luminance is {:.3f} instead of {:.3f}",
                         stimulus.id, found.reached, found.wanted),
             "change its background, use equalize: {luminance: {by: figure}}, or omit luminance");
  }
  return list.take();
}

struct ExposedFilm {
  std::string stimulus;
  const Adjustment& found;
};

constexpr auto exposure_columns = table_of<ExposedFilm>(
    "metrics/exposure.csv", "stimulus, if luminance is equalized",
    {{"stimulus", "", "id of the stimulus", [](auto& r) { return r.stimulus; }},
     {"mean_luminance", "0–1", "relative luminance (linear) of sampled frames before equalizing",
      [](auto& r) { return std::round(1e6 * r.found.mean) / 1e6; }},
     {"wanted_luminance", "0–1",
      "luminance to which all films (with by: figure, all with the same kind of figure) are "
      "brought: the geometric mean of their luminances before equalizing; point-light films that "
      "share an exposure enter by their mean",
      [](auto& r) { return std::round(1e6 * r.found.wanted) / 1e6; }},
     {"exposure_stops", "stops", "exposure compensation: 1 doubles the light, −1 halves it",
      [](auto& r) { return r.found.stops; }}});

void refuse(std::vector<Fault> faults) {
  if (!faults.empty()) throw Faults(std::move(faults));
}

}  // namespace

const TableForm exposure_form = exposure_columns.form();

float stops_for(const std::vector<render::Framebuffer>& films, const render::Tone& tone,
                double wanted) {
  return stops_where([&](float stops) { return mean_of(films, tone, stops); }, wanted);
}

std::string exposure_csv(const Manifest& manifest, const FilmSettings& settings,
                         FinishedMotions& motions, TaskRun& run, EqualizedFilms& films) {
  refuse(faults_in_light(manifest, motions));
  constexpr Sampling sampling;
  SamplesById samples;
  for (const Stimulus& stimulus : manifest.stimuli) {
    samples[stimulus.id] =
        samples_of(stimulus, sampling, settings, motions, films.of(stimulus.id).framing, run.stop);
    run.progress(static_cast<double>(samples.size()) /
                 static_cast<double>(manifest.stimuli.size()));
  }
  const AdjustmentsById adjustments = adjustments_of(manifest, samples);
  refuse(faults_of(manifest, adjustments, sampling));
  std::vector<ExposedFilm> rows;
  for (const Stimulus& stimulus : manifest.stimuli) {
    rows.push_back({stimulus.id, adjustments.at(stimulus.id)});
    films.exposure_stops[stimulus.id] = rows.back().found.stops;
  }
  return exposure_columns.of(rows).csv;
}

std::vector<Fault> faults_in_light(const Manifest& manifest, FinishedMotions& motions) {
  const FilmSettings settings{.seed = manifest.seed};
  SamplesById samples;
  for (const Stimulus& stimulus : manifest.stimuli)
    samples[stimulus.id] = samples_of(stimulus, quick_sampling, settings, motions, {}, {});
  return faults_of(manifest, adjustments_of(manifest, samples), quick_sampling);
}

}  // namespace mien::pipeline
