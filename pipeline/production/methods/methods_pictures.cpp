#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "motion/measures/distance/distance.h"
#include "pipeline/production/film/film.h"
#include "pipeline/production/film/film_dots.h"
#include "pipeline/production/methods/methods_parts.h"
#include "pipeline/production/methods/prose.h"
#include "pipeline/production/methods/study_facts.h"
#include "render/video/video_kind.h"

namespace mien::pipeline {

namespace {

void tell_looks(MethodsText& out) {
  Names figures, scenes, cameras, sizes, rates, qualities;
  for (const Stimulus* film : films_of(out.manifest)) {
    const Output& output = film->output;
    const auto [width, height] = output.shown_size();
    add_once(figures, figure_name(film->look));
    add_once(scenes, scene_name(film->look));
    add_once(cameras, film->look.camera.view);
    add_once(sizes, fmt::format("{} × {}", width, height));
    add_once(rates, fmt::format("{:g}", output.fps));
    add_once(qualities,
             std::to_string(quality_of(FilmSettings{.output = output}).samples_per_pixel));
  }
  out.say(fmt::format(
      "Motions were shown on {} ({}; set: {}; camera: {}), ray-traced{} in pictures "
      "of {} pixels with {} samples a pixel, {} a second",
      figures.size() == 1 ? "one figure" : "several figures", listed(figures), listed(scenes),
      listed(cameras), out.cite({"embree2014"}), listed(sizes), listed(qualities), listed(rates)));
}

void tell_videos(MethodsText& out) {
  Range seconds;
  Names kinds;
  for (const Stimulus& stimulus : out.manifest.stimuli) {
    seconds.add(out.motions.shown(stimulus).frame_count() / stimulus.output.fps);
  }
  for (const Stimulus* film : films_of(out.manifest)) {
    for (const render::VideoKind kind : film->output.video)
      add_once(kinds, std::string(render::traits_of(kind).name));
  }
  out.say("The films last " + with_mean(seconds, 2, " s"));
  if (kinds.empty()) return;
  out.say(
      fmt::format("They were written as {}, and every video was decoded again and compared with "
                  "the pictures drawn",
                  listed(kinds)));
}

void tell_equalizing(MethodsText& out) {
  Names alike;
  if (out.manifest.equalize.duration) alike.emplace_back("length, that of the shortest");
  const auto add = [&](const std::optional<Among>& among, const std::string& what) {
    if (!among) return;
    alike.push_back(what +
                    (among == Among::figure ? " (among those with the same kind of figure)" : ""));
  };
  add(out.manifest.equalize.size,
      "height of the standing figure, that of the smallest, by the camera");
  add(out.manifest.equalize.place,
      "place of the figure in the picture, the mean of them, by its shift");
  add(out.manifest.equalize.luminance,
      "mean luminance, the geometric mean of them, by the exposure");
  if (!alike.empty()) out.say("The films of the stimuli were made alike in " + listed(alike));
  if (out.manifest.equalize.luminance && std::ranges::any_of(out.manifest.stimuli, has_dots)) {
    out.say(
        "Point lights with equally many dots of one size and colour share one exposure, so that "
        "their dots have one luminance wherever they are moved, as by scrambling, while the "
        "means of their films may differ; it is that of the dots themselves which the exposure "
        "changes (metrics/exposure.csv)");
  }
}

bool compares_files(MethodsText& out) {
  return std::ranges::any_of(out.manifest.sheets, [&](const Sheet& sheet) {
    const std::vector<MotionPair> pairs = pairs_on(sheet);
    return std::ranges::any_of(pairs, [&](const MotionPair& pair) {
      const Stimulus* target = out.motions.stimulus(pair.target);
      const Stimulus* created = out.motions.stimulus(pair.created);
      return (target && target->clip) || (created && created->clip);
    });
  });
}

void tell_distances(MethodsText& out) {
  Range distances;
  std::size_t matches = 0;
  for (const Sheet& sheet : out.manifest.sheets) {
    if (!sheet.gallery.empty()) continue;  // side by side, and not one for the other
    for (const auto& [target, created] : pairs_on(sheet)) {
      const motion::Distance d = out.motions.distance(target, created);
      distances.add(d.mean);
      matches += d.matches() ? 1 : 0;
    }
  }
  if (distances.count == 0) return;
  out.say(fmt::format(
      "The distance D of two motions is the mean distance of {} joints at {} corresponding "
      "moments, place and heading of the body taken out{}",
      motion::distance_joints, motion::distance_times, out.cite({"adjectives"})));
  if (compares_files(out)) {
    out.say(
        "Before it was measured, planted feet of motion files were locked to the floor, as those "
        "of blends are");
  }
  out.say(fmt::format(
      "Of {} compared, D is {}; {} below {:g} m, at which a trial of the matching "
      "task ends; whether people see a difference is another question",
      count_of(static_cast<std::size_t>(distances.count), "pair", "pairs"),
      with_mean(distances, 4, " m"), matches == 0 ? "none lies" : count_of(matches, "lies", "lie"),
      motion::distance_threshold_m));
}

}  // namespace

void describe_pictures(MethodsText& out) {
  tell_looks(out);
  tell_videos(out);
  describe_settings(out);
  tell_equalizing(out);
  tell_distances(out);
}

}  // namespace mien::pipeline
