#include "pipeline/production/design/property_values.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/people.h"
#include "pipeline/production/film/film_record.h"
#include "pipeline/production/film/film_shot.h"
#include "pipeline/production/film/film_tables.h"
#include "pipeline/production/methods/study_facts.h"
#include "pipeline/tasks/parallel.h"
#include "scenes/cameras/figure_place.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

PropertyValue& at(PropertyValues& values, std::string_view id) {
  std::size_t i = 0;
  while (stimulus_properties[i].id != id) ++i;
  return values[i];
}

std::string or_default(const std::string& options) { return options.empty() ? "default" : options; }

std::string camera(const Look& look) {
  const std::string options = camera_options(look);
  return options.empty() ? look.camera.view : look.camera.view + " " + options;
}

std::string colours(const Stimulus& stimulus) {
  std::string text = stimulus.look.colours == Colours::role ? std::string(name_of(stimulus.role))
                                                            : std::string("neutral");
  if (!stimulus.look.background.empty()) text += " on " + stimulus.look.background;
  return text;
}

/// Metres that a motion travels per second.
double speed_of(const motion::Clip& clip) {
  if (clip.poses.empty() || clip.duration_seconds() <= 0.0) return 0.0;
  const motion::Vec3 way =
      clip.loops ? clip.cycle_displacement
                 : motion::Vec3(clip.poses.back().root_position - clip.poses.front().root_position);
  return std::hypot(way.x(), way.z()) / clip.duration_seconds();
}

/// The mean over the people where there are several.
double mean_speed_of(const Stimulus& stimulus, Motions& motions) {
  const auto shown = motions_in(stimulus);
  double sum = 0.0;
  for (const Stimulus* motion : shown) sum += speed_of(motions.of(motion->id).motion.clip);
  return sum / static_cast<double>(shown.size());
}

/// The name of the sound file, with that of its folder if another file has the same name, and the
/// time at which it begins.
std::string sound_text(const Manifest& manifest, const Stimulus& stimulus) {
  if (!stimulus.sound) return without_sound;
  const fs::path& file = stimulus.sound->file;
  const bool has_namesake = std::ranges::any_of(manifest.stimuli, [&](const Stimulus& other) {
    return other.sound && other.sound->file != file &&
           other.sound->file.filename() == file.filename();
  });
  std::string text = file.filename().string();
  if (has_namesake) text = file.parent_path().filename().string() + "/" + text;
  const double offset = stimulus.sound->offset;
  return offset == 0.0 ? text : fmt::format("{} from {:g} s", text, offset);
}

/// All properties of the look and the motion.
PropertyValues stated_properties(const Manifest& manifest, const Stimulus& stimulus,
                                 Motions& motions) {
  const auto [width, height] = stimulus.output.shown_size();
  PropertyValues values;
  at(values, "figure").text = scenes::kind_of(stimulus.look.figure).name;
  at(values, "figure_options").text = or_default(figure_options(stimulus));
  at(values, "colours").text = colours(stimulus);
  at(values, "set").text = scene_name(stimulus.look);
  at(values, "camera").text = camera(stimulus.look);
  at(values, "picture_size").text = fmt::format("{} × {}", width, height);
  at(values, "frame_rate").text = shortest(stimulus.output.fps);
  at(values, "sound").text = sound_text(manifest, stimulus);
  at(values, "in_place").text = stimulus.output.in_place ? "yes" : "no";
  at(values, "speed").number = mean_speed_of(stimulus, motions);
  return values;
}

void set_duration(PropertyValues& values, const Stimulus& stimulus, double seconds) {
  at(values, "duration").number = seconds;
  at(values, "distance").number =
      stimulus.output.in_place ? 0.0 : seconds * at(values, "speed").number;
}

/// The properties of all stimuli, several at a time.
template <class Find>
std::vector<PropertyValues> of_all(const Manifest& manifest, const Find& find) {
  std::vector<PropertyValues> all(manifest.stimuli.size());
  on_all_processors(all.size(), [&](std::size_t i) { all[i] = find(manifest.stimuli[i]); });
  return all;
}

}  // namespace

std::vector<PropertyValues> planned_properties(const Manifest& manifest, Motions& motions) {
  return of_all(manifest, [&](const Stimulus& stimulus) {
    PropertyValues values = stated_properties(manifest, stimulus, motions);
    const scenes::Shot shot = shot_of(stimulus, motions, manifest.seed);
    if (!manifest.equalize.duration)
      set_duration(values, stimulus, shot.frame_count() / stimulus.output.fps);
    if (!manifest.equalize.size)
      at(values, "figure_height").number = scenes::figure_pixels(shot.cameras);
    return values;
  });
}

std::vector<PropertyValues> filmed_properties(const Manifest& manifest, Motions& motions,
                                              const fs::path& folder) {
  return of_all(manifest, [&](const Stimulus& stimulus) {
    PropertyValues values = stated_properties(manifest, stimulus, motions);
    const FilmRecord film = parse_film_record(read_file(folder / film_record_path(stimulus.id)));
    set_duration(values, stimulus, film.film_frames / stimulus.output.fps);
    at(values, "figure_height").number = film.figure_px;
    at(values, "luminance").number = film.luminance.mean;
    if (film.sound && film.sound->loudness_lufs)
      at(values, "loudness").number = *film.sound->loudness_lufs;
    return values;
  });
}

}  // namespace mien::pipeline
