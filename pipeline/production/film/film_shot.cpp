#include "pipeline/production/film/film_shot.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "motion/math/geometry.h"
#include "motion/skeleton/clip.h"
#include "pipeline/manifest/derived_seed.h"
#include "pipeline/manifest/look/look.h"
#include "pipeline/manifest/person_figure.h"
#include "pipeline/production/clips/people_clips.h"
#include "scenes/figures/figure_colour.h"

namespace mien::pipeline {

namespace {

scenes::Look look_of(const Stimulus& film, std::uint64_t seed) {
  scenes::Look look = staged_look(film.look, film.output, derived_seed(seed, "dots of " + film.id));
  look.role = film_role(film);
  return look;
}

scenes::Look framed_look(const Stimulus& film, std::uint64_t seed, const Framing& framing) {
  scenes::Look look = look_of(film, seed);
  if (framing.figure_px) look.camera.figure_px = *framing.figure_px / look.pixel_scale;
  look.figure_place = framing.figure_place;
  return look;
}

/// Whether a person stays where it was recorded.
bool is_where_recorded(const Person& person) { return person.motion.clip && !person.place; }

motion::Vec3 start_of(const motion::Clip& clip) {
  const motion::Vec3& at = clip.poses.front().root_position;
  return {at.x(), 0.0, at.z()};
}

/// The middle of the people who stay where they were recorded when the film begins, on the floor.
motion::Vec3 captured_middle(const Stimulus& stimulus, const std::vector<motion::Clip>& clips) {
  motion::Vec3 sum = motion::Vec3::Zero();
  int count = 0;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    if (!is_where_recorded(stimulus.people[i])) continue;
    sum += start_of(clips[i]);
    ++count;
  }
  return count == 0 ? sum : motion::Vec3(sum / count);
}

/// The figure of a person; dots have its colour too.
scenes::Figure coloured_figure(const Person& person, const Look& look) {
  scenes::Figure figure = figure_of(person, look);
  if (auto* dots = scenes::dots_in(figure); dots != nullptr && !person.colour.empty())
    dots->colour = person.colour;
  return figure;
}

/// What is shown of a motion that was made for another film, which may have another frame rate.
motion::Clip clip_at_rate(const motion::Clip& made, const Output& output) {
  return playback_clip(motion::resampled(made, output.fps), output);
}

/// Output of a clip for a set. A set that moves under the figure needs the figure's speed.
Output output_for(Output output, const scenes::SetPlan& set) {
  if (set.in_place) output.in_place = false;
  return output;
}

}  // namespace

scenes::Look staged_look(const Look& look, const Output& output, std::uint64_t seed) {
  return {.set = staged_set(look),
          .figure = shown_figure(look),
          .hands = look.hands,
          .camera = look.camera,
          .size = output.whole_size(),
          .window = output.window(),
          .pixel_scale = output.scale,
          .detail = output.quality == Quality::draft ? scenes::MeshDetail::draft
                                                     : scenes::MeshDetail::full,
          .seed = seed};
}

Role film_role(const Stimulus& stimulus) {
  return stimulus.look.colours == Colours::role ? stimulus.role : Role::neutral;
}

motion::Clip staged_clip(const Stimulus& stimulus, FinishedMotions& motions) {
  Stimulus shown = stimulus;
  shown.output = output_for(shown.output, staged_set(stimulus.look));
  return motions.shown(shown);
}

scenes::Shot shot_of(const Stimulus& stimulus, FinishedMotions& motions, std::uint64_t seed,
                     const Framing& framing) {
  if (stimulus.people.empty())
    return shot_of(stimulus, staged_clip(stimulus, motions), seed, framing);
  return shot_of(stimulus, placed_people(stimulus, motions), seed, framing);
}

scenes::Shot shot_of(const Stimulus& stimulus, const motion::Clip& clip, std::uint64_t seed,
                     const Framing& framing) {
  return scenes::stage(clip, framed_look(stimulus, seed, framing));
}

motion::Vec3 stage_front(const Stimulus& stimulus, const std::vector<motion::Clip>& people) {
  if (!std::ranges::all_of(stimulus.people, is_where_recorded)) return motion::Vec3::UnitZ();
  const motion::Vec3 across = start_of(people[1]) - start_of(people[0]);
  constexpr double together_m = 0.05;
  if (across.norm() < together_m) return motion::Vec3::UnitZ();
  return across.normalized().cross(motion::Vec3::UnitY());
}

scenes::Shot shot_of(const Stimulus& stimulus, std::vector<motion::Clip> people, std::uint64_t seed,
                     const Framing& framing) {
  scenes::Look look = framed_look(stimulus, seed, framing);
  look.layout = scenes::Layout::as_recorded;
  look.forward = stage_front(stimulus, people);
  std::vector<scenes::Performance> performances;
  for (std::size_t i = 0; i < people.size(); ++i) {
    const Person& person = stimulus.people[i];
    const std::string_view colour =
        person.colour.empty() ? scenes::person_colour(i) : std::string_view(person.colour);
    scenes::Figure figure = coloured_figure(person, stimulus.look);
    if (auto* dots = scenes::dots_in(figure)) dots->size_px *= look.pixel_scale;
    performances.push_back({.name = person.name,
                            .clip = std::move(people[i]),
                            .colours = scenes::colours_of_hex(colour),
                            .figure = std::move(figure),
                            .hands = person.hands});
  }
  return scenes::stage(performances, look);
}

std::vector<motion::Clip> placed_people(const Stimulus& stimulus, FinishedMotions& motions) {
  std::vector<motion::Clip> clips = people_clips(stimulus, motions);
  const motion::Vec3 to_middle = -captured_middle(stimulus, clips);
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const Person& person = stimulus.people[i];
    if (person.place) {
      const motion::Vec3 at(person.place->x, 0.0, person.place->z);
      clips[i] = scenes::placed(clips[i], at, motion::radians_per_degree * person.place->turn);
    } else if (person.motion.clip) {
      clips[i] = scenes::shifted(clips[i], to_middle);
    }
  }
  return clips;
}

scenes::Shot shot_of(const Overlay& overlay, FinishedMotions& motions, std::uint64_t seed) {
  scenes::Look look = look_of(overlay.film, seed);
  look.layout = overlay.layout;
  const Output output = output_for(overlay.film.output, look.set);
  const bool is_clear = overlay.layout != scenes::Layout::superimposed;
  std::vector<scenes::Performance> performances;
  for (const auto& [role, name] : motions_on(overlay)) {
    performances.push_back({.name = name,
                            .clip = clip_at_rate(motions.clip(name), output),
                            .role = role,
                            .opacity = is_clear ? 1.0f : static_cast<float>(overlay.opacity)});
  }
  return scenes::stage(performances, look);
}

}  // namespace mien::pipeline
