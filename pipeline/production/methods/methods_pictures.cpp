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

void describe_looks(MethodsText& out) {
  Names figures, scenes, cameras, sizes, rates, qualities;
  for (const Stimulus* film : films_of(out.manifest)) {
    const Output& output = film->output;
    const auto [width, height] = output.shown_size();
    if (film->people.empty()) add_once(figures, scenes::kind_of(film->look.figure).name);
    for (const Person& person : film->people)
      add_once(figures, scenes::kind_of(person.figure ? *person.figure : film->look.figure).name);
    add_once(scenes, scene_name(film->look));
    add_once(cameras, film->look.camera.view);
    add_once(sizes, fmt::format("{} × {}", width, height));
    add_once(rates, fmt::format("{:g}", output.fps));
    add_once(qualities,
             std::to_string(quality_of(FilmSettings{.output = output}).samples_per_pixel));
  }
  out.say(fmt::format(
      "Motions were rendered with {} ({}; set: {}; camera: {}), ray-traced{} at {} pixels "
      "with {} samples per pixel and {} frames per second",
      figures.size() == 1 ? "one figure type" : "several figure types", listed(figures),
      listed(scenes), listed(cameras), out.cite({"embree2014"}), listed(sizes), listed(qualities),
      listed(rates)));
}

void describe_videos(MethodsText& out) {
  Range seconds;
  Names kinds;
  for (const Stimulus& stimulus : out.manifest.stimuli) {
    seconds.add(out.motions.shown_frames(stimulus) / stimulus.output.fps);
  }
  for (const Stimulus* film : films_of(out.manifest)) {
    for (const render::VideoKind kind : film->output.video)
      add_once(kinds, std::string(render::traits_of(kind).description));
  }
  out.say("The films lasted " + with_mean(seconds, 2, " s"));
  if (kinds.empty()) return;
  out.say(fmt::format(
      "They were encoded as {}; every video was decoded and compared with the rendered frames",
      listed(kinds)));
}

void describe_equalization(MethodsText& out) {
  Names alike;
  if (out.manifest.equalize.duration) alike.emplace_back("duration (to the shortest)");
  const auto add = [&](const std::optional<EqualizeGroup>& among, const std::string& what) {
    if (!among) return;
    alike.push_back(what +
                    (among == EqualizeGroup::figure ? ", separately for each kind of figure" : ""));
  };
  add(out.manifest.equalize.size,
      "height of the standing figure (to the smallest, by camera distance)");
  add(out.manifest.equalize.place,
      "position of the figure in the image (to the mean, by shifting the image)");
  add(out.manifest.equalize.luminance, "mean luminance (to the geometric mean, by exposure)");
  if (!alike.empty()) out.say("The films of the stimuli were equalized in " + listed(alike));
  if (out.manifest.equalize.luminance && std::ranges::any_of(out.manifest.stimuli, has_dots)) {
    out.say(
        "Figures of dots on the same set whose dots differ only in arrangement and motion "
        "share one exposure, so that their dots have the same luminance wherever they move (also "
        "when scrambled), while the mean luminance of their films may differ; the exposure changes "
        "the luminance of the dots themselves (metrics/exposure.csv)");
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

void describe_distances(MethodsText& out) {
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
  out.say(
      fmt::format("The distance D between two motions is the mean distance of {} joints at {} "
                  "corresponding moments, with the horizontal position and heading of the pelvis "
                  "removed at each moment and its height kept{}",
                  motion::distance_joints, motion::distance_times, out.cite({"adjectives"})));
  if (compares_files(out)) {
    out.say(
        "Before measuring, planted feet of motion files were locked to the floor, as in blends");
  }
  out.say(fmt::format(
      "For {}, D was {}; {} below {:g} m, the threshold that ends a trial of a published matching "
      "task{} and that is not a measure of perceptibility",
      count_of(static_cast<std::size_t>(distances.count), "compared pair", "compared pairs"),
      with_mean(distances, 4, " m"), matches == 0 ? "none was" : count_of(matches, "was", "were"),
      motion::distance_threshold_m, out.cite({"adjectives"})));
}

}  // namespace

void describe_pictures(MethodsText& out) {
  describe_looks(out);
  describe_videos(out);
  describe_settings(out);
  describe_equalization(out);
  describe_sounds(out);
  describe_distances(out);
}

}  // namespace mien::pipeline
